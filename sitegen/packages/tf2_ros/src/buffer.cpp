#include "tf2_ros/buffer.hpp"

#include <chrono>
#include <sstream>
#include <thread>
#include <tuple>
#include <utility>

namespace tf2_ros
{

const char * const threading_error =
  "Do not call canTransform or lookupTransform with a timeout unless you are using another thread "
  "for populating data. Without a dedicated thread it will always timeout.  If you have a separate "
  "thread servicing tf messages, call setUsingDedicatedThread(true) on your Buffer instance.";

Buffer::Buffer(rclcpp::Clock::SharedPtr clock, tf2::Duration cache_time)
: BufferCore(cache_time), clock_(std::move(clock))
{
  if (!clock_) {throw std::invalid_argument("clock must be a valid instance");}
  const rcl_jump_threshold_t backwards{true, {0}, {-1}};
  jump_handler_ = clock_->create_jump_callback(
    nullptr, [this](const rcl_time_jump_t & jump) {
      const bool switched = jump.clock_change == RCL_ROS_TIME_ACTIVATED ||
        jump.clock_change == RCL_ROS_TIME_DEACTIVATED;
      if (switched || jump.delta.nanoseconds < 0) {
        RCLCPP_WARN(logger_, "Detected jump back in time. Clearing TF buffer.");
        clear();
      }
    }, backwards);
}

geometry_msgs::msg::TransformStamped Buffer::lookupTransform(
  const std::string & target_frame, const std::string & source_frame,
  const tf2::TimePoint & time, const tf2::Duration timeout) const
{
  std::string error;  // what is wrong, the other one says
  canTransform(target_frame, source_frame, time, timeout, &error);
  return lookupTransform(target_frame, source_frame, time);
}

geometry_msgs::msg::TransformStamped Buffer::lookupTransform(
  const std::string & target_frame, const tf2::TimePoint & target_time,
  const std::string & source_frame, const tf2::TimePoint & source_time,
  const std::string & fixed_frame, const tf2::Duration timeout) const
{
  std::string error;
  canTransform(
    target_frame, target_time, source_frame, source_time, fixed_frame, timeout, &error);
  return lookupTransform(target_frame, target_time, source_frame, source_time, fixed_frame);
}

bool Buffer::canTransform(
  const std::string & target_frame, const std::string & source_frame,
  const tf2::TimePoint & time, const tf2::Duration timeout, std::string * error) const
{
  return wait(
    [&](std::string * why) {return canTransform(target_frame, source_frame, time, why);},
    timeout, error);
}

bool Buffer::canTransform(
  const std::string & target_frame, const tf2::TimePoint & target_time,
  const std::string & source_frame, const tf2::TimePoint & source_time,
  const std::string & fixed_frame, const tf2::Duration timeout, std::string * error) const
{
  return wait(
    [&](std::string * why) {
      return canTransform(
        target_frame, target_time, source_frame, source_time, fixed_frame, why);
    }, timeout, error);
}

bool Buffer::wait(
  const std::function<bool(std::string *)> & can, tf2::Duration timeout,
  std::string * error) const
{
  if (timeout != tf2::Duration::zero() && !isUsingDedicatedThread()) {
    if (error) {*error = threading_error;}
    RCLCPP_ERROR(logger_, "%s", threading_error);
    return false;
  }
  const rclcpp::Time begun = clock_->now();
  const rclcpp::Time end = begun + rclcpp::Duration(timeout);
  std::string why;
  // A clock that jumps back means that a recording was restarted.
  while (!can(&why) && clock_->now() < end && clock_->now() + rclcpp::Duration(3, 0) >= begun &&
    rclcpp::ok())
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  if (!error) {return can(nullptr);}
  const bool can_now = can(error);
  std::ostringstream text;
  text << ". canTransform returned after " << (clock_->now() - begun).seconds() <<
    " timeout was " << tf2::durationToSec(timeout) << ".";
  *error += text.str();
  return can_now;
}

TransformStampedFuture Buffer::waitForTransform(
  const std::string & target_frame, const std::string & source_frame,
  const tf2::TimePoint & time, const tf2::Duration & timeout, TransformReadyCallback callback)
{
  if (!timer_interface_) {
    throw CreateTimerInterfaceException("timer interface not set before call to waitForTransform");
  }
  auto promise = std::make_shared<std::promise<geometry_msgs::msg::TransformStamped>>();
  TransformStampedFuture future(promise->get_future());
  const auto fail = [promise](const auto & exception) {
      promise->set_exception(std::make_exception_ptr(exception));
    };
  const auto succeed = [this, promise, target_frame, source_frame, time]() {
      try {
        promise->set_value(lookupTransform(target_frame, source_frame, time));
      } catch (...) {
        promise->set_exception(std::current_exception());
      }
    };
  const std::string way = "from " + source_frame + " to " + target_frame;
  const auto handle = addTransformableRequest(
    [this, callback, future, fail, succeed, way](
      auto request, const auto &, const auto &, auto, auto result) mutable {
      remove_timer(request);
      if (result == tf2::TransformAvailable) {
        succeed();
      } else {
        fail(tf2::LookupException("Failed to transform " + way));
      }
      future.setHandle(request);
      callback(future);
    }, target_frame, source_frame, time);
  future.setHandle(handle);
  if (handle == 0) {
    succeed();
    callback(future);
  } else if (handle == 0xffffffffffffffffULL) {
    fail(tf2::LookupException("Failed to transform " + way));
    callback(future);
  } else {
    const auto timer = timer_interface_->createTimer(
      clock_, timeout, [this, handle, future, fail, callback, way](const TimerHandle &) {
        cancelTransformableRequest(handle);
        // Copies, because this function is destroyed with its timer.
        const auto [give_up, call, answer, text] = std::tuple(fail, callback, future, way);
        remove_timer(handle);
        give_up(tf2::TimeoutException("Timed out waiting for transform " + text));
        call(answer);
      });
    const std::lock_guard<std::mutex> lock(timers_mutex_);
    timers_[handle] = timer;
  }
  return future;
}

void Buffer::cancel(const TransformStampedFuture & future)
{
  cancelTransformableRequest(future.getHandle());
  remove_timer(future.getHandle());
}

void Buffer::remove_timer(tf2::TransformableRequestHandle request)
{
  const std::lock_guard<std::mutex> lock(timers_mutex_);
  const auto found = timers_.find(request);
  if (found != timers_.end()) {
    timer_interface_->remove(found->second);
    timers_.erase(found);
  }
}

}  // namespace tf2_ros
