#pragma once

#include <chrono>

#include "rclcpp/clock.hpp"
#include "rclcpp/duration.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{

class RateBase
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(RateBase)

  virtual ~RateBase() = default;
  virtual bool sleep() = 0;
  virtual bool is_steady() const = 0;
  virtual rcl_clock_type_t get_type() const = 0;
  virtual void reset() = 0;
};

/// Sleeps for the rest of each period of its clock.
class Rate : public RateBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Rate)

  explicit Rate(
    double hertz, Clock::SharedPtr clock = std::make_shared<Clock>(RCL_SYSTEM_TIME));
  explicit Rate(
    const Duration & period, Clock::SharedPtr clock = std::make_shared<Clock>(RCL_SYSTEM_TIME));

  /// Sleep until the end of the period; false at once if it has already ended.
  bool sleep() override;
  bool is_steady() const override {return get_type() == RCL_STEADY_TIME;}
  rcl_clock_type_t get_type() const override {return clock_->get_clock_type();}
  void reset() override;
  std::chrono::nanoseconds period() const {return period_.to_chrono<std::chrono::nanoseconds>();}

private:
  Clock::SharedPtr clock_;
  Duration period_;
  Time last_;
};

/// The rate of Humble, whose clock is one of std::chrono.
template<class ClockT = std::chrono::high_resolution_clock>
class GenericRate : public Rate
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericRate)

  explicit GenericRate(double hertz)
  : Rate(hertz, clock()) {}
  explicit GenericRate(std::chrono::nanoseconds period)
  : Rate(Duration(period), clock()) {}

private:
  static Clock::SharedPtr clock()
  {
    return std::make_shared<Clock>(ClockT::is_steady ? RCL_STEADY_TIME : RCL_SYSTEM_TIME);
  }
};

class WallRate : public Rate
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(WallRate)

  explicit WallRate(double hertz)
  : Rate(hertz, std::make_shared<Clock>(RCL_STEADY_TIME)) {}
  explicit WallRate(const Duration & period)
  : Rate(period, std::make_shared<Clock>(RCL_STEADY_TIME)) {}
};

class ROSRate : public Rate
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ROSRate)

  explicit ROSRate(double hertz)
  : Rate(hertz, std::make_shared<Clock>(RCL_ROS_TIME)) {}
  explicit ROSRate(const Duration & period)
  : Rate(period, std::make_shared<Clock>(RCL_ROS_TIME)) {}
};

}  // namespace rclcpp
