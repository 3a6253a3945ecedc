#pragma once

#include "rclcpp/executor.hpp"

namespace rclcpp
{
namespace executors
{

class StaticSingleThreadedExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(StaticSingleThreadedExecutor)

  using Executor::Executor;
};

}  // namespace executors
}  // namespace rclcpp
