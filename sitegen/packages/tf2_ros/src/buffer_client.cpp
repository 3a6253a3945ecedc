#include "tf2_ros/buffer_client.hpp"

#include <chrono>
#include <functional>
#include <future>

#include "rclcpp/utilities.hpp"

namespace tf2_ros
{

using Action = BufferClient::LookupTransformAction;
using tf2_msgs::msg::TF2Error;

namespace
{

Action::Goal goal_of(
  const std::string & target_frame, const std::string & source_frame, const tf2::TimePoint & time,
  const tf2::Duration & timeout)
{
  Action::Goal goal;
  goal.target_frame = target_frame;
  goal.source_frame = source_frame;
  goal.source_time = toMsg(time);
  goal.timeout = toMsg(timeout);
  return goal;
}

Action::Goal goal_of(
  const std::string & target_frame, const tf2::TimePoint & target_time,
  const std::string & source_frame, const tf2::TimePoint & source_time,
  const std::string & fixed_frame, const tf2::Duration & timeout)
{
  Action::Goal goal = goal_of(target_frame, source_frame, source_time, timeout);
  goal.target_time = toMsg(target_time);
  goal.fixed_frame = fixed_frame;
  goal.advanced = true;
  return goal;
}

[[noreturn]] void fail(const TF2Error & error)
{
  switch (error.error) {
    case TF2Error::LOOKUP_ERROR: throw tf2::LookupException(error.error_string);
    case TF2Error::CONNECTIVITY_ERROR: throw tf2::ConnectivityException(error.error_string);
    case TF2Error::EXTRAPOLATION_ERROR: throw tf2::ExtrapolationException(error.error_string);
    case TF2Error::INVALID_ARGUMENT_ERROR: throw tf2::InvalidArgumentException(error.error_string);
    case TF2Error::TIMEOUT_ERROR: throw tf2::TimeoutException(error.error_string);
    default: throw tf2::TransformException(error.error_string);
  }
}

bool succeeds(const std::function<void()> & lookup, std::string * error)
{
  try {
    lookup();
    return true;
  } catch (const tf2::TransformException & exception) {
    if (error) {*error = exception.what();}
  } catch (const LookupTransformGoalException & exception) {
    if (error) {*error = exception.what();}
  }
  return false;
}

}  // namespace

geometry_msgs::msg::TransformStamped BufferClient::lookupTransform(
  const std::string & target_frame, const std::string & source_frame, const tf2::TimePoint & time,
  const tf2::Duration timeout) const
{
  return ask(goal_of(target_frame, source_frame, time, timeout));
}

geometry_msgs::msg::TransformStamped BufferClient::lookupTransform(
  const std::string & target_frame, const tf2::TimePoint & target_time,
  const std::string & source_frame, const tf2::TimePoint & source_time,
  const std::string & fixed_frame, const tf2::Duration timeout) const
{
  return ask(
    goal_of(target_frame, target_time, source_frame, source_time, fixed_frame, timeout));
}

bool BufferClient::canTransform(
  const std::string & target_frame, const std::string & source_frame, const tf2::TimePoint & time,
  const tf2::Duration timeout, std::string * error) const
{
  return succeeds([&] {lookupTransform(target_frame, source_frame, time, timeout);}, error);
}

bool BufferClient::canTransform(
  const std::string & target_frame, const tf2::TimePoint & target_time,
  const std::string & source_frame, const tf2::TimePoint & source_time,
  const std::string & fixed_frame, const tf2::Duration timeout, std::string * error) const
{
  return succeeds(
    [&] {
      lookupTransform(
        target_frame, target_time, source_frame, source_time, fixed_frame, timeout);
    }, error);
}

geometry_msgs::msg::TransformStamped BufferClient::ask(const Action::Goal & goal) const
{
  const auto end = std::chrono::steady_clock::now() + fromMsg(goal.timeout) + timeout_padding_;
  const auto wait = [&](const auto & future) {
      while (rclcpp::ok() && std::chrono::steady_clock::now() < end) {
        if (future.wait_for(check_period_) == std::future_status::ready) {return;}
      }
      throw tf2::TimeoutException("Did not receive the result for the goal before timeout");
    };
  const auto sent = client_->async_send_goal(goal);
  wait(sent);
  const auto handle = sent.get();
  if (!handle) {throw GoalRejectedException("Goal rejected by action server");}
  const auto result = client_->async_get_result(handle);
  wait(result);
  const auto wrapped = result.get();
  switch (wrapped.code) {
    case rclcpp_action::ResultCode::SUCCEEDED:
      break;
    case rclcpp_action::ResultCode::ABORTED:
      throw GoalAbortedException("LookupTransform action was aborted");
    case rclcpp_action::ResultCode::CANCELED:
      throw GoalCanceledException("LookupTransform action was canceled");
    default:
      throw UnexpectedResultCodeException("Unexpected result code returned from server");
  }
  if (wrapped.result->error.error != TF2Error::NO_ERROR) {fail(wrapped.result->error);}
  return wrapped.result->transform;
}

}  // namespace tf2_ros
