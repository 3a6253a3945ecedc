#pragma once

namespace rclcpp
{

/// How upstream keeps messages within a program. Here they are lent, see detail/lent.hpp.
enum class IntraProcessBufferType {SharedPtr, UniquePtr, CallbackDefault};

}  // namespace rclcpp
