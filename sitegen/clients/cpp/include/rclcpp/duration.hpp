#pragma once

#include <chrono>
#include <cstdint>

#include "builtin_interfaces/msg/duration.hpp"
#include "builtin_interfaces/msg/time.hpp"
#include "rcl/time.h"
#include "rmw/types.h"

namespace rclcpp
{

/// A duration in nanoseconds.
class Duration
{
public:
  Duration() = default;
  Duration(std::int32_t seconds, std::uint32_t nanoseconds)
  : nanoseconds_(seconds * std::int64_t{1000000000} + nanoseconds) {}
  explicit Duration(std::chrono::nanoseconds duration)
  : nanoseconds_(duration.count()) {}
  template<class Rep, class Period>
  Duration(const std::chrono::duration<Rep, Period> & duration)  // NOLINT: implicit upstream
  : nanoseconds_(std::chrono::duration_cast<std::chrono::nanoseconds>(duration).count()) {}
  Duration(const builtin_interfaces::msg::Duration & message)  // NOLINT: implicit upstream
  : Duration(message.sec, message.nanosec) {}

  explicit Duration(const rcl_duration_t & duration)
  : nanoseconds_(duration.nanoseconds) {}

  static Duration from_nanoseconds(std::int64_t nanoseconds)
  {
    return Duration(std::chrono::nanoseconds(nanoseconds));
  }
  static Duration from_seconds(double seconds)
  {
    return from_nanoseconds(static_cast<std::int64_t>(seconds * 1e9));
  }
  static Duration from_rmw_time(rmw_time_t time);
  /// The maximum duration of a message.
  static Duration max() {return Duration(INT32_MAX, 999999999);}

  operator builtin_interfaces::msg::Duration() const;  // NOLINT: implicit upstream

  std::int64_t nanoseconds() const {return nanoseconds_;}
  /// Throws std::runtime_error if it is negative.
  rmw_time_t to_rmw_time() const;
  double seconds() const {return static_cast<double>(nanoseconds_) / 1e9;}

  template<class DurationT>
  DurationT to_chrono() const
  {
    return std::chrono::duration_cast<DurationT>(std::chrono::nanoseconds(nanoseconds_));
  }

  bool operator==(const Duration & other) const {return nanoseconds_ == other.nanoseconds_;}
  bool operator!=(const Duration & other) const {return nanoseconds_ != other.nanoseconds_;}
  bool operator<(const Duration & other) const {return nanoseconds_ < other.nanoseconds_;}
  bool operator<=(const Duration & other) const {return nanoseconds_ <= other.nanoseconds_;}
  bool operator>(const Duration & other) const {return nanoseconds_ > other.nanoseconds_;}
  bool operator>=(const Duration & other) const {return nanoseconds_ >= other.nanoseconds_;}
  /// These throw std::overflow_error or std::underflow_error, as upstream.
  Duration operator+(const Duration & other) const;
  Duration operator-(const Duration & other) const;
  Duration & operator+=(const Duration & other) {return *this = *this + other;}
  Duration & operator-=(const Duration & other) {return *this = *this - other;}
  /// Throws std::runtime_error if `scale` is infinite or not a number.
  Duration operator*(double scale) const;
  Duration & operator*=(double scale) {return *this = *this * scale;}

private:
  std::int64_t nanoseconds_ = 0;
};

namespace detail
{
/// The limit of a QoS policy without one: RMW_DURATION_INFINITE, in nanoseconds.
constexpr std::int64_t kInfinite = INT64_MAX;
}  // namespace detail

/// These throw std::runtime_error if the time is negative, and what those of Duration throw.
builtin_interfaces::msg::Time operator+(
  const builtin_interfaces::msg::Time & time, const Duration & duration);
builtin_interfaces::msg::Time operator-(
  const builtin_interfaces::msg::Time & time, const Duration & duration);

}  // namespace rclcpp
