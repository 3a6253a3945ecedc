#pragma once

#include <type_traits>

#include "rclcpp/type_adapter.hpp"
#include "rosidl_runtime_cpp/traits.hpp"

namespace rclcpp
{

/// Whether `T` is a message or is adapted to one.
template<class T>
struct is_ros_compatible_type
  : std::bool_constant<
    rosidl_generator_traits::is_message<T>::value || TypeAdapter<T>::is_specialized::value> {};

}  // namespace rclcpp
