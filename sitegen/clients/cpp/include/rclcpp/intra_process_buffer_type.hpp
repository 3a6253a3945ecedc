#pragma once

namespace rclcpp
{

/// Has no effect: see detail/intra_process.hpp.
enum class IntraProcessBufferType {SharedPtr, UniquePtr, CallbackDefault};

}  // namespace rclcpp
