#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "rclcpp/clock.hpp"
#include "rclcpp/detail/executable.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{

/// The expected and the actual time of a timer's call, in nanoseconds of its clock.
struct TimerInfo
{
  Time expected_call_time;
  Time actual_call_time;
};

/// Runs a callback once per period. Missed periods are skipped, as in rcl.
class TimerBase : public detail::Executable
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(TimerBase)
  RCLCPP_DISABLE_COPY(TimerBase)

  using Callback = std::function<void (TimerBase & timer, const TimerInfo & info)>;

  TimerBase(
    Clock::SharedPtr clock, std::chrono::nanoseconds period, Callback callback,
    bool autostart = true);
  ~TimerBase() override;

  void cancel() {canceled_ = true;}
  bool is_canceled() const {return canceled_;}
  void reset();
  /// Run the callback at each reset with their number: of those before it was set, or 1.
  void set_on_reset_callback(std::function<void (std::size_t)> callback);
  void clear_on_reset_callback() {on_reset_ = nullptr;}
  bool is_ready() const;
  /// Time until the next call, negative if late; max() if canceled.
  std::chrono::nanoseconds time_until_trigger() const;
  Clock::SharedPtr get_clock() const {return clock_;}
  bool is_steady() const {return clock_->get_clock_type() == RCL_STEADY_TIME;}
  bool exchange_in_use_by_wait_set_state(bool in_use);

  /// Start the next period; null if canceled. The callback runs afterwards, with or without the
  /// result.
  std::shared_ptr<void> call();
  void execute_callback(const std::shared_ptr<void> & info = nullptr);

  bool execute_one() override;
  std::int64_t time_left() const override;

private:
  friend class Clock;

  /// Keep what is left of the period before the source of the clock changes.
  void save_left();
  void follow_jump(bool source_changed);
  void tell_of_resets();

  Clock::SharedPtr clock_;
  TimerBase * next_on_clock_ = nullptr;
  std::int64_t period_;  // ns, as the following, on its clock
  std::int64_t last_;
  std::int64_t next_;
  std::int64_t left_ = 0;
  bool canceled_;
  bool in_use_by_wait_set_ = false;
  std::shared_ptr<TimerInfo> info_ = std::make_shared<TimerInfo>();
  Callback callback_;
  std::function<void (std::size_t)> on_reset_;
  std::size_t resets_ = 0;  // that no callback was told of
};

namespace detail
{

/// `callback` has any form that timers accept.
template<class CallbackT>
TimerBase::Callback timer_callback(CallbackT callback)
{
  if constexpr (std::is_invocable_v<CallbackT &, TimerBase &>) {
    return [callback = std::move(callback)](TimerBase & timer, const TimerInfo &) mutable {
             callback(timer);
           };
  } else if constexpr (std::is_invocable_v<CallbackT &, const TimerInfo &>) {
    return [callback = std::move(callback)](TimerBase &, const TimerInfo & info) mutable {
             callback(info);
           };
  } else {
    return [callback = std::move(callback)](TimerBase &, const TimerInfo &) mutable {callback();};
  }
}

/// A period in nanoseconds. Throws std::invalid_argument if it is negative or too long.
template<class Rep, class Period>
std::chrono::nanoseconds timer_period(std::chrono::duration<Rep, Period> period)
{
  if (period < std::chrono::duration<Rep, Period>::zero()) {
    throw std::invalid_argument("timer period cannot be negative");
  }
  if (std::chrono::duration<double, std::nano>(period).count() >= 9.2e18) {
    throw std::invalid_argument("timer period must be less than std::chrono::nanoseconds::max()");
  }
  return std::chrono::duration_cast<std::chrono::nanoseconds>(period);
}

}  // namespace detail

class Context;

using VoidCallbackType = std::function<void ()>;
using TimerCallbackType = std::function<void (TimerBase &)>;
using TimerInfoCallbackType = std::function<void (const TimerInfo &)>;

template<class FunctorT, class = void>
class GenericTimer : public TimerBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericTimer)

  using TimerBase::TimerBase;
  /// As upstream. NodeTimersInterface::add_timer() starts it.
  GenericTimer(
    Clock::SharedPtr clock, std::chrono::nanoseconds period, FunctorT callback,
    std::shared_ptr<Context>, bool autostart = true)
  : TimerBase(
      std::move(clock), period, detail::timer_callback(std::move(callback)), autostart) {}
};

template<class FunctorT, class = void>
class WallTimer : public GenericTimer<FunctorT>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(WallTimer)

  WallTimer(std::chrono::nanoseconds period, TimerBase::Callback callback, bool autostart = true)
  : GenericTimer<FunctorT>(
      std::make_shared<Clock>(RCL_STEADY_TIME), period, std::move(callback), autostart) {}
  WallTimer(
    std::chrono::nanoseconds period, FunctorT callback, std::shared_ptr<Context> context,
    bool autostart = true)
  : GenericTimer<FunctorT>(
      std::make_shared<Clock>(RCL_STEADY_TIME), period, std::move(callback), std::move(context),
      autostart) {}
};

}  // namespace rclcpp
