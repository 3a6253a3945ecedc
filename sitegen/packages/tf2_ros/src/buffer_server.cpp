#include "tf2_ros/buffer_server.hpp"

#include <memory>
#include <string>

#include "tf2/exceptions.hpp"
#include "tf2_ros/buffer_interface.hpp"

namespace tf2_ros
{

using Result = BufferServer::LookupTransformAction::Result;
using tf2_msgs::msg::TF2Error;

rclcpp_action::CancelResponse BufferServer::cancel(const GoalHandle & handle)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  for (auto one = waiting_.begin(); one != waiting_.end(); ++one) {
    if (one->handle->get_goal_id() == handle->get_goal_id()) {
      // It is reported as canceled at the next check.
      one->end = tf2::TimePoint::min();
      return rclcpp_action::CancelResponse::ACCEPT;
    }
  }
  return rclcpp_action::CancelResponse::REJECT;
}

void BufferServer::accept(const GoalHandle & handle)
{
  const tf2::Duration timeout = fromMsg(handle->get_goal()->timeout);
  if (can_answer(handle) || timeout <= tf2::Duration::zero()) {
    answer(handle);
    return;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  waiting_.push_back({handle, tf2::get_now() + timeout});
}

void BufferServer::check()
{
  std::list<Waiting> done;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (auto one = waiting_.begin(); one != waiting_.end(); ) {
      const auto next = std::next(one);
      if (tf2::get_now() >= one->end || can_answer(one->handle)) {
        done.splice(done.end(), waiting_, one);
      }
      one = next;
    }
  }
  for (const Waiting & one : done) {
    if (one.handle->is_canceling()) {
      one.handle->canceled(std::make_shared<Result>());
    } else {
      answer(one.handle);
    }
  }
}

bool BufferServer::can_answer(const GoalHandle & handle) const
{
  const auto goal = handle->get_goal();
  const auto source_time = fromMsg(goal->source_time);
  std::string error;  // else the buffer warns, each time that it is asked
  if (!goal->advanced) {
    return buffer_.canTransform(goal->target_frame, goal->source_frame, source_time, &error);
  }
  return buffer_.canTransform(
    goal->target_frame, fromMsg(goal->target_time), goal->source_frame, source_time,
    goal->fixed_frame, &error);
}

void BufferServer::answer(const GoalHandle & handle) const
{
  const auto goal = handle->get_goal();
  const auto source_time = fromMsg(goal->source_time);
  auto result = std::make_shared<Result>();
  const auto fail = [&](std::uint8_t error, const tf2::TransformException & exception) {
      result->error.error = error;
      result->error.error_string = exception.what();
    };
  try {
    result->transform = goal->advanced ?
      buffer_.lookupTransform(
      goal->target_frame, fromMsg(goal->target_time), goal->source_frame, source_time,
      goal->fixed_frame) :
      buffer_.lookupTransform(goal->target_frame, goal->source_frame, source_time);
  } catch (const tf2::ConnectivityException & exception) {
    fail(TF2Error::CONNECTIVITY_ERROR, exception);
  } catch (const tf2::LookupException & exception) {
    fail(TF2Error::LOOKUP_ERROR, exception);
  } catch (const tf2::ExtrapolationException & exception) {
    fail(TF2Error::EXTRAPOLATION_ERROR, exception);
  } catch (const tf2::InvalidArgumentException & exception) {
    fail(TF2Error::INVALID_ARGUMENT_ERROR, exception);
  } catch (const tf2::TimeoutException & exception) {
    fail(TF2Error::TIMEOUT_ERROR, exception);
  } catch (const tf2::TransformException & exception) {
    fail(TF2Error::TRANSFORM_ERROR, exception);
  }
  handle->succeed(result);
}

}  // namespace tf2_ros
