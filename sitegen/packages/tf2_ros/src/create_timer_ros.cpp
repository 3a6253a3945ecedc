#include "tf2_ros/create_timer_ros.hpp"

#include <utility>

#include "rclcpp/create_timer.hpp"

namespace tf2_ros
{

CreateTimerROS::CreateTimerROS(
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base,
  rclcpp::node_interfaces::NodeTimersInterface::SharedPtr,
  rclcpp::CallbackGroup::SharedPtr callback_group)
: node_base_(std::move(node_base)), callback_group_(std::move(callback_group)) {}

TimerHandle CreateTimerROS::createTimer(
  rclcpp::Clock::SharedPtr clock, const tf2::Duration & period, TimerCallbackType callback)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const TimerHandle handle = next_++;
  timers_[handle] = rclcpp::create_timer(
    node_base_, std::move(clock), rclcpp::Duration(period),
    std::function<void()>([callback = std::move(callback), handle]() {callback(handle);}),
    callback_group_);
  return handle;
}

rclcpp::TimerBase::SharedPtr CreateTimerROS::timer(TimerHandle handle) const
{
  const auto found = timers_.find(handle);
  if (found == timers_.end()) {
    throw InvalidTimerHandleException("Invalid timer handle: " + std::to_string(handle));
  }
  return found->second;
}

void CreateTimerROS::cancel(const TimerHandle & timer_handle)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  timer(timer_handle)->cancel();
}

void CreateTimerROS::reset(const TimerHandle & timer_handle)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  timer(timer_handle)->reset();
}

void CreateTimerROS::remove(const TimerHandle & timer_handle)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  timer(timer_handle)->cancel();
  timers_.erase(timer_handle);
}

}  // namespace tf2_ros
