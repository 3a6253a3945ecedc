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
  if (state_->source) {state_->source->take();}
  return Time(time(), state_->type);
}

std::int64_t Clock::time() const
{
  return state_->source ? state_->ros_time : detail::nanoseconds(detail::now());
}

bool Clock::ros_time_is_active() const
{
  if (state_->type != RCL_ROS_TIME) {
    throw exceptions::RCLError("failed to check ros_time_override_status: clock is not of ROS time");
  }
  return state_->source;
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
  if (until.get_clock_type() != state_->type) {
    throw std::runtime_error("until's clock type does not match this clock's type");
  }
  const auto source = state_->source;
  const auto cancels = state_->cancels;
  const auto goes_on = [&] {
      return context->is_valid() && source == state_->source && cancels == state_->cancels;
    };
  do {
    const double left = static_cast<double>((until - now()).nanoseconds()) / 1e6;
    // Simulated time advances by messages, which end all waits.
    detail::wait(source && left > 0 ? -1 : std::max(0.0, left));
  } while (goes_on() && now() < until);
  return goes_on();
}

void Clock::cancel_sleep_or_wait()
{
  ++state_->cancels;
  detail::wake();
}

bool Clock::wait_until_started(Context::SharedPtr context)
{
  const auto cancels = state_->cancels;
  while (context->is_valid() && cancels == state_->cancels && !started()) {detail::wait(-1);}
  return started();
}

JumpHandler::SharedPtr Clock::create_jump_callback(
  JumpHandler::pre_callback_t pre_callback, JumpHandler::post_callback_t post_callback,
  const rcl_jump_threshold_t & threshold)
{
  auto handler = std::make_shared<JumpHandler>(
    std::move(pre_callback), std::move(post_callback), threshold);
  state_->handlers.push_back(handler);
  return handler;
}

void Clock::jump(
  const rcl_time_jump_t & jump, detail::SimulatedTime * source, std::int64_t nanoseconds)
{
  const std::int64_t delta = jump.delta.nanoseconds;
  const bool changed = jump.clock_change != RCL_ROS_TIME_NO_CHANGE;
  std::vector<JumpHandler::SharedPtr> told;
  for (const auto & handler : state_->handlers) {
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
  for (auto timer = state_->timers; changed && timer; timer = timer->next_on_clock_) {
    timer->save_left();
  }
  state_->source = source;
  state_->ros_time = nanoseconds;
  for (auto timer = state_->timers; timer; timer = timer->next_on_clock_) {
    timer->follow_jump(changed);
  }
  for (const auto & handler : told) {
    if (handler->post_callback) {handler->post_callback(jump);}
  }
  detail::wake();
}

void Clock::set_source(detail::SimulatedTime * source, std::int64_t nanoseconds)
{
  if (!source == !state_->source) {return;}
  jump({source ? RCL_ROS_TIME_ACTIVATED : RCL_ROS_TIME_DEACTIVATED, {0}}, source, 0);
  set_ros_time(nanoseconds);
}

void Clock::set_ros_time(std::int64_t nanoseconds)
{
  if (!state_->source || nanoseconds == state_->ros_time) {return;}
  jump({RCL_ROS_TIME_NO_CHANGE, {nanoseconds - state_->ros_time}}, state_->source, nanoseconds);
}

}  // namespace rclcpp
