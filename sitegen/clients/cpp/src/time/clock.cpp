#include "rclcpp/clock.hpp"

#include <algorithm>
#include <utility>

#include "rclcpp/detail/platform.hpp"
#include "rclcpp/detail/stacks.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/timer.hpp"

namespace rclcpp
{

Time Clock::now() const
{
  if (source_) {source_->take();}
  return Time(time(), clock_);
}

std::int64_t Clock::time() const
{
  return source_ ? ros_time_ : detail::nanoseconds(detail::now());
}

bool Clock::ros_time_is_active() const
{
  if (clock_ != RCL_ROS_TIME) {
    throw exceptions::RCLError("failed to check ros_time_override_status: clock is not of ROS time");
  }
  return source_;
}

bool Clock::sleep_for(Duration duration, Context::SharedPtr context)
{
  return sleep_until(now() + duration, std::move(context));
}

bool Clock::sleep_until(Time until, Context::SharedPtr context)
{
  if (!context || !context->is_valid()) {
    throw std::runtime_error("context cannot be slept with because it's invalid");
  }
  if (until.get_clock_type() != clock_) {
    throw std::runtime_error("until's clock type does not match this clock's type");
  }
  const auto source = source_;
  do {
    const double left = static_cast<double>((until - now()).nanoseconds()) / 1e6;
    // Simulated time advances by messages, which end all waits.
    detail::wait(source && left > 0 ? -1 : std::max(0.0, left));
  } while (context->is_valid() && source == source_ && now() < until);
  return context->is_valid() && source == source_;
}

bool Clock::wait_until_started(Context::SharedPtr context)
{
  while (context->is_valid() && !started()) {detail::wait(-1);}
  return started();
}

JumpHandler::SharedPtr Clock::create_jump_callback(
  JumpHandler::pre_callback_t pre_callback, JumpHandler::post_callback_t post_callback,
  const rcl_jump_threshold_t & threshold)
{
  auto handler = std::make_shared<JumpHandler>(
    std::move(pre_callback), std::move(post_callback), threshold);
  handlers_.push_back(handler);
  return handler;
}

void Clock::jump(
  const rcl_time_jump_t & jump, detail::SimulatedTime * source, std::int64_t nanoseconds)
{
  const std::int64_t delta = jump.delta.nanoseconds;
  const bool changed = jump.clock_change != RCL_ROS_TIME_NO_CHANGE;
  std::vector<JumpHandler::SharedPtr> told;
  for (const auto & handler : handlers_) {
    auto living = handler.lock();
    if (!living) {continue;}
    const auto & threshold = living->notice_threshold;
    const bool far =
      (threshold.min_forward.nanoseconds > 0 && delta >= threshold.min_forward.nanoseconds) ||
      (threshold.min_backward.nanoseconds < 0 && delta <= threshold.min_backward.nanoseconds);
    if (far || (changed && threshold.on_clock_change)) {told.push_back(std::move(living));}
  }
  for (const auto & handler : told) {
    if (handler->pre_callback) {handler->pre_callback();}
  }
  for (auto timer = timers_; changed && timer; timer = timer->next_on_clock_) {timer->save_left();}
  source_ = source;
  ros_time_ = nanoseconds;
  for (auto timer = timers_; timer; timer = timer->next_on_clock_) {timer->follow_jump(changed);}
  for (const auto & handler : told) {
    if (handler->post_callback) {handler->post_callback(jump);}
  }
  detail::wake();
}

void Clock::set_source(detail::SimulatedTime * source, std::int64_t nanoseconds)
{
  if (!source == !source_) {return;}
  jump({source ? RCL_ROS_TIME_ACTIVATED : RCL_ROS_TIME_DEACTIVATED, {0}}, source, 0);
  set_ros_time(nanoseconds);
}

void Clock::set_ros_time(std::int64_t nanoseconds)
{
  if (!source_ || nanoseconds == ros_time_) {return;}
  jump({RCL_ROS_TIME_NO_CHANGE, {nanoseconds - ros_time_}}, source_, nanoseconds);
}

}  // namespace rclcpp
