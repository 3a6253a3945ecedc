#pragma once

#include <cstddef>

#include "rclcpp/context.hpp"
#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/memory_strategy.hpp"

namespace rclcpp
{

struct ExecutorOptions
{
  ExecutorOptions()
  : context(contexts::get_global_default_context()) {}

  memory_strategy::MemoryStrategy::SharedPtr memory_strategy;
  Context::SharedPtr context;
  std::size_t max_conditions = 0;
};

}  // namespace rclcpp
