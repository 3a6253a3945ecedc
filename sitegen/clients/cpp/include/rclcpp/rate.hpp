#pragma once

#include <chrono>

#include "rclcpp/macros.hpp"

namespace rclcpp
{

class RateBase
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(RateBase)

  virtual ~RateBase() = default;
  virtual bool sleep() = 0;
  virtual void reset() = 0;
};

/// Sleeps for the rest of each period.
class Rate : public RateBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Rate)

  explicit Rate(double hertz);
  explicit Rate(std::chrono::nanoseconds period);

  /// Sleep until the period ends; false at once when it had ended before.
  bool sleep() override;
  void reset() override;
  std::chrono::nanoseconds period() const {return period_;}

private:
  std::chrono::nanoseconds period_;
  double last_;  // ms, on the clock of ros_now
};

using WallRate = Rate;

}  // namespace rclcpp
