#pragma once

#include <memory>
#include <type_traits>

#include "rclcpp/function_traits.hpp"
#include "rclcpp/serialized_message.hpp"
#include "rmw/types.h"

namespace rclcpp
{

namespace serialization_traits
{

template<class T>
struct is_serialized_message_class
  : std::bool_constant<
    std::is_same_v<T, rcl_serialized_message_t> || std::is_same_v<T, SerializedMessage>> {};

}  // namespace serialization_traits

namespace subscription_traits
{

namespace detail
{

template<class T>
struct Pointee {using type = T;};
template<class T>
struct Pointee<std::shared_ptr<T>> {using type = T;};
template<class T, class DeleterT>
struct Pointee<std::unique_ptr<T, DeleterT>> {using type = T;};

template<class T>
using message_of = std::remove_cv_t<typename Pointee<std::remove_cv_t<std::remove_reference_t<T>>>::type>;

}  // namespace detail

/// Whether a parameter of a callback takes serialized messages, by value, reference or pointer.
template<class T>
struct is_serialized_subscription_argument
  : serialization_traits::is_serialized_message_class<detail::message_of<T>> {};

template<class T>
struct is_serialized_subscription : is_serialized_subscription_argument<T> {};

template<class CallbackT>
struct is_serialized_callback
  : is_serialized_subscription_argument<
    typename function_traits::function_traits<CallbackT>::template argument_type<0>> {};

}  // namespace subscription_traits
}  // namespace rclcpp
