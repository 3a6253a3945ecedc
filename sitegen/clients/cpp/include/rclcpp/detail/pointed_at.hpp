#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace rclcpp
{
namespace detail
{

template<class T, class = void>
struct points : std::is_pointer<T> {};
template<class T>
struct points<T, std::void_t<decltype(std::declval<T &>().operator->())>> : std::true_type {};

/// The object that `object` points to; `object` itself if it is not a pointer.
template<class T>
auto & pointed_at(T & object)
{
  if constexpr (points<std::decay_t<T>>::value) {
    return *object;
  } else {
    return object;
  }
}

}  // namespace detail
}  // namespace rclcpp
