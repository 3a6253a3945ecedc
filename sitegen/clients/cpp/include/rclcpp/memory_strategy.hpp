#pragma once

#include "rclcpp/macros.hpp"

namespace rclcpp
{
namespace memory_strategy
{

/// Accepted and unused: executors do not store the entities of a wait.
class MemoryStrategy
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(MemoryStrategy)

  virtual ~MemoryStrategy() = default;
};

}  // namespace memory_strategy
}  // namespace rclcpp
