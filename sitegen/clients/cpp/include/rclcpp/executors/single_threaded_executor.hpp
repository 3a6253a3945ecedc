#pragma once

#include "rclcpp/executor.hpp"

namespace rclcpp
{
namespace executors
{

class SingleThreadedExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SingleThreadedExecutor)

  using Executor::Executor;
};

}  // namespace executors
}  // namespace rclcpp
