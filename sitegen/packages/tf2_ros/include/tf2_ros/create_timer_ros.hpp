#pragma once

#include <mutex>
#include <unordered_map>

#include "rclcpp/callback_group.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_parts.hpp"
#include "rclcpp/timer.hpp"
#include "tf2_ros/create_timer_interface.hpp"

namespace tf2_ros
{

/// Creates timers of a node.
class CreateTimerROS : public CreateTimerInterface
{
public:
  CreateTimerROS(
    rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base,
    rclcpp::node_interfaces::NodeTimersInterface::SharedPtr node_timers,
    rclcpp::CallbackGroup::SharedPtr callback_group = nullptr);

  TimerHandle createTimer(
    rclcpp::Clock::SharedPtr clock, const tf2::Duration & period,
    TimerCallbackType callback) override;
  /// These throw InvalidTimerHandleException for the number of a timer that does not exist.
  void cancel(const TimerHandle & timer_handle) override;
  void reset(const TimerHandle & timer_handle) override;
  void remove(const TimerHandle & timer_handle) override;

private:
  rclcpp::TimerBase::SharedPtr timer(TimerHandle handle) const;

  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base_;
  rclcpp::CallbackGroup::SharedPtr callback_group_;
  TimerHandle next_ = 0;
  std::unordered_map<TimerHandle, rclcpp::TimerBase::SharedPtr> timers_;
  mutable std::mutex mutex_;
};

}  // namespace tf2_ros
