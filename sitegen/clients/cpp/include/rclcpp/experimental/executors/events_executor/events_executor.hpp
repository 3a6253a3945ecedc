#pragma once

#include "rclcpp/executor.hpp"

namespace rclcpp
{
namespace experimental
{
namespace executors
{

class EventsExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(EventsExecutor)

  using Executor::Executor;
};

}  // namespace executors
}  // namespace experimental
}  // namespace rclcpp
