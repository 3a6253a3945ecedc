#pragma once

#include <memory>
#include <type_traits>

namespace rcpputils
{

/// What a pointer or a standard smart pointer points to; `T` itself if it is no pointer.
template<class T>
struct remove_pointer : std::remove_pointer<T> {};
template<class T, class ... Rest>
struct remove_pointer<std::unique_ptr<T, Rest...>> {using type = T;};
template<class T>
struct remove_pointer<std::shared_ptr<T>> {using type = T;};
template<class T>
using remove_pointer_t = typename remove_pointer<std::remove_cv_t<T>>::type;

template<class T>
struct is_pointer
  : std::bool_constant<!std::is_same_v<remove_pointer_t<T>, std::remove_cv_t<T>>> {};

}  // namespace rcpputils
