#include "rclcpp/clock.hpp"

#include <algorithm>
#include <utility>

#include "rclcpp/detail/platform.hpp"
#include "rclcpp/detail/stacks.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/logging.hpp"

namespace rclcpp
{

Time Clock::now() const
{
  if (source_) {
    source_();
    return Time(ros_time_, clock_);
  }
  return Time(detail::nanoseconds(detail::now()), clock_);
}

bool Clock::ros_time_is_active() const
{
  if (clock_ != RCL_ROS_TIME) {
    throw exceptions::RCLError("failed to check ros_time_override_status: clock is not of ROS time");
  }
  return static_cast<bool>(source_);
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
    RCLCPP_ERROR(get_logger("rclcpp"), "until's clock type does not match this clock's type");
    return false;
  }
  const bool active = static_cast<bool>(source_);
  do {
    const double left = static_cast<double>((until - now()).nanoseconds()) / 1e6;
    // ROS time advances by messages, which end all waits.
    detail::wait(active ? -1 : std::max(0.0, left));
  } while (context->is_valid() && active == static_cast<bool>(source_) && now() < until);
  return context->is_valid() && active == static_cast<bool>(source_);
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
  std::int64_t delta, rcl_clock_change_t change, const std::function<void()> & act)
{
  const bool changed = change != RCL_ROS_TIME_NO_CHANGE;
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
  act();
  for (const auto & handler : told) {
    if (handler->post_callback) {handler->post_callback({change, {delta}});}
  }
  detail::wake();
}

void Clock::set_source(std::function<void()> source, std::int64_t nanoseconds)
{
  const bool active = static_cast<bool>(source);
  if (active == static_cast<bool>(source_)) {return;}
  const auto system = Clock(RCL_ROS_TIME).now().nanoseconds();
  const std::int64_t delta = active ? nanoseconds - system : system - ros_time_;
  jump(
    delta, active ? RCL_ROS_TIME_ACTIVATED : RCL_ROS_TIME_DEACTIVATED, [&] {
      source_ = std::move(source);
      ros_time_ = nanoseconds;
    });
}

void Clock::set_ros_time(std::int64_t nanoseconds)
{
  if (!source_) {return;}
  jump(
    nanoseconds - ros_time_, RCL_ROS_TIME_NO_CHANGE, [this, nanoseconds] {ros_time_ = nanoseconds;});
}

}  // namespace rclcpp
