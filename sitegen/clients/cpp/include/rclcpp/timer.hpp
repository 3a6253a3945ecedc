#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include "rclcpp/macros.hpp"

namespace rclcpp
{

/// Calls back once a period. A period that was missed is skipped, as in rcl.
class TimerBase
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(TimerBase)
  RCLCPP_DISABLE_COPY(TimerBase)

  TimerBase(
    std::chrono::nanoseconds period, std::function<void(TimerBase &)> callback,
    bool autostart = true);
  virtual ~TimerBase() = default;

  void cancel();
  bool is_canceled() const {return canceled_;}
  void reset();
  bool is_ready() const;
  /// Time until the next call; max() when canceled.
  std::chrono::nanoseconds time_until_trigger() const;

  /// Call back and arm the timer for its next period.
  void execute();

private:
  double period_;  // ms, as next_, on the clock of ros_now
  double next_;
  bool canceled_;
  std::function<void(TimerBase &)> callback_;
};

template<class FunctorT>
using WallTimer = TimerBase;

}  // namespace rclcpp
