#pragma once

#include "rclcpp/macros.hpp"

namespace rclcpp
{
namespace memory_strategy
{

/// Kept by executors and not asked: they look at what is there, and store nothing of it.
class MemoryStrategy
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(MemoryStrategy)

  virtual ~MemoryStrategy() = default;
};

}  // namespace memory_strategy
}  // namespace rclcpp
