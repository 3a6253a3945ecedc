#pragma once

#include "rclcpp/macros.hpp"
#include "rclcpp/time.hpp"

namespace rclcpp
{

class Clock
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Clock)

  explicit Clock(rcl_clock_type_t clock = RCL_SYSTEM_TIME)
  : clock_(clock) {}

  Time now() const;
  rcl_clock_type_t get_clock_type() const {return clock_;}
  bool sleep_for(const Duration & duration) const;
  bool sleep_until(const Time & until) const;

private:
  rcl_clock_type_t clock_;
};

}  // namespace rclcpp
