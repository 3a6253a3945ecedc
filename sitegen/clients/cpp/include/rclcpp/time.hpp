#pragma once

#include <cstdint>
#include <limits>

#include "builtin_interfaces/msg/time.hpp"
#include "rcl/time.h"
#include "rclcpp/duration.hpp"

namespace rclcpp
{

/// A point in time of one kind of clock; times of different kinds cannot be compared.
class Time
{
public:
  Time(
    std::int32_t seconds, std::uint32_t nanoseconds, rcl_clock_type_t clock = RCL_SYSTEM_TIME);
  explicit Time(std::int64_t nanoseconds = 0, rcl_clock_type_t clock = RCL_SYSTEM_TIME)
  : nanoseconds_(nanoseconds), clock_(clock) {}
  Time(  // NOLINT: implicit upstream
    const builtin_interfaces::msg::Time & message, rcl_clock_type_t clock = RCL_ROS_TIME)
  : Time(message.sec, message.nanosec, clock) {}

  explicit Time(const rcl_time_point_t & point)
  : Time(point.nanoseconds, point.clock_type) {}

  /// The maximum time of a message.
  static Time max(rcl_clock_type_t clock = RCL_SYSTEM_TIME)
  {
    return Time(INT32_MAX, 999999999, clock);
  }

  operator builtin_interfaces::msg::Time() const;  // NOLINT: implicit upstream

  std::int64_t nanoseconds() const {return nanoseconds_;}
  double seconds() const {return static_cast<double>(nanoseconds_) / 1e9;}
  rcl_clock_type_t get_clock_type() const {return clock_;}

  bool operator==(const Time & other) const {return compare(other) == 0;}
  bool operator!=(const Time & other) const {return compare(other) != 0;}
  bool operator<(const Time & other) const {return compare(other) < 0;}
  bool operator<=(const Time & other) const {return compare(other) <= 0;}
  bool operator>(const Time & other) const {return compare(other) > 0;}
  bool operator>=(const Time & other) const {return compare(other) >= 0;}
  Duration operator-(const Time & other) const;
  Time operator+(const Duration & duration) const;
  Time operator-(const Duration & duration) const;
  Time & operator+=(const Duration & duration) {return *this = *this + duration;}
  Time & operator-=(const Duration & duration) {return *this = *this - duration;}

private:
  int compare(const Time & other) const;

  std::int64_t nanoseconds_;
  rcl_clock_type_t clock_;
};

inline Time operator+(const Duration & duration, const Time & time) {return time + duration;}

/// Whether the sum or the difference of two integers is above or below the limits of their type.
template<typename T>
bool add_will_overflow(const T x, const T y)
{
  return y > 0 && x > std::numeric_limits<T>::max() - y;
}
template<typename T>
bool add_will_underflow(const T x, const T y)
{
  return y < 0 && x < std::numeric_limits<T>::min() - y;
}
template<typename T>
bool sub_will_overflow(const T x, const T y)
{
  return y < 0 && x > std::numeric_limits<T>::max() + y;
}
template<typename T>
bool sub_will_underflow(const T x, const T y)
{
  return y > 0 && x < std::numeric_limits<T>::min() + y;
}

}  // namespace rclcpp
