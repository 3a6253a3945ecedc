#pragma once

#include <memory>

#include "rclcpp/memory_strategy.hpp"

namespace rclcpp
{
namespace memory_strategies
{

inline memory_strategy::MemoryStrategy::SharedPtr create_default_strategy()
{
  return std::make_shared<memory_strategy::MemoryStrategy>();
}

}  // namespace memory_strategies
}  // namespace rclcpp
