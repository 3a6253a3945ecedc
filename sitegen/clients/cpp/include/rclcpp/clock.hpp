#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "rclcpp/context.hpp"
#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/time.hpp"

enum rcl_clock_change_t
{
  RCL_ROS_TIME_NO_CHANGE = 1,
  RCL_ROS_TIME_ACTIVATED = 2,
  RCL_ROS_TIME_DEACTIVATED = 3,
  RCL_SYSTEM_TIME_NO_CHANGE = 4
};

struct rcl_time_jump_t
{
  rcl_clock_change_t clock_change;
  rcl_duration_t delta;
};

struct rcl_jump_threshold_t
{
  bool on_clock_change;
  rcl_duration_t min_forward;
  rcl_duration_t min_backward;
};

namespace rclcpp
{

class TimerBase;
class TimeSource;

namespace detail
{

/// What ROS clocks get simulated time from.
class SimulatedTime
{
public:
  /// Set the clocks to the latest time.
  virtual void take() = 0;

protected:
  ~SimulatedTime() = default;
};

}  // namespace detail

/// Callbacks for time jumps larger than `notice_threshold`.
class JumpHandler
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(JumpHandler)

  using pre_callback_t = std::function<void ()>;
  using post_callback_t = std::function<void (const rcl_time_jump_t &)>;

  JumpHandler(
    pre_callback_t pre_callback, post_callback_t post_callback,
    const rcl_jump_threshold_t & threshold)
  : pre_callback(std::move(pre_callback)), post_callback(std::move(post_callback)),
    notice_threshold(threshold) {}

  pre_callback_t pre_callback;
  post_callback_t post_callback;
  rcl_jump_threshold_t notice_threshold;
};

/// A clock of system time, steady time or ROS time, which a TimeSource may set. Copies are the same
/// clock.
class Clock
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Clock)

  explicit Clock(rcl_clock_type_t clock = RCL_SYSTEM_TIME)
  : state_(std::make_shared<State>()) {state_->type = clock;}

  Time now() const;
  rcl_clock_type_t get_clock_type() const {return state_->type;}
  std::mutex & get_clock_mutex() noexcept {return state_->mutex;}
  /// Whether ROS time comes from /clock. Throws RCLError for other clocks.
  bool ros_time_is_active() const;
  /// These return false on shutdown, when canceled, or if the source of the clock changes.
  bool sleep_for(
    Duration duration,
    Context::SharedPtr context = contexts::get_global_default_context());
  bool sleep_until(
    Time until, Context::SharedPtr context = contexts::get_global_default_context());
  /// End the sleeps and waits of other threads with this clock, which return false.
  void cancel_sleep_or_wait();
  bool started() const {return now().nanoseconds() != 0;}
  bool wait_until_started(
    Context::SharedPtr context = contexts::get_global_default_context());
  JumpHandler::SharedPtr create_jump_callback(
    JumpHandler::pre_callback_t pre_callback, JumpHandler::post_callback_t post_callback,
    const rcl_jump_threshold_t & threshold);

private:
  friend class TimerBase;
  friend class TimeSource;

  /// The time in nanoseconds, without the messages that the source has not taken yet.
  std::int64_t time() const;
  /// Set where ROS time comes from, and its time; null for system time.
  void set_source(detail::SimulatedTime * source, std::int64_t nanoseconds);
  void set_ros_time(std::int64_t nanoseconds);
  void jump(
    const rcl_time_jump_t & jump, detail::SimulatedTime * source, std::int64_t nanoseconds);

  struct State
  {
    rcl_clock_type_t type;
    detail::SimulatedTime * source = nullptr;
    std::int64_t ros_time = 0;
    unsigned cancels = 0;
    TimerBase * timers = nullptr;  // the first of those on this clock
    std::vector<JumpHandler::WeakPtr> handlers;
    std::mutex mutex;
  };

  std::shared_ptr<State> state_;
};

}  // namespace rclcpp
