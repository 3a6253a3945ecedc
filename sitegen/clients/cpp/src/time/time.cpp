#include "rclcpp/time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace rclcpp
{

namespace
{

constexpr std::int64_t kSecond = 1000000000;

std::int64_t add(std::int64_t a, std::int64_t b)
{
  std::int64_t sum;
  if (__builtin_add_overflow(a, b, &sum)) {
    if (b > 0) {throw std::overflow_error("addition leads to int64_t overflow");}
    throw std::underflow_error("addition leads to int64_t underflow");
  }
  return sum;
}

std::int64_t subtract(std::int64_t a, std::int64_t b)
{
  std::int64_t difference;
  if (__builtin_sub_overflow(a, b, &difference)) {
    if (b < 0) {throw std::overflow_error("subtraction leads to int64_t overflow");}
    throw std::underflow_error("subtraction leads to int64_t underflow");
  }
  return difference;
}

/// Split `nanoseconds` into a message's seconds and nanoseconds, the latter never negative.
template<class MessageT>
MessageT split(std::int64_t nanoseconds)
{
  std::int64_t seconds = nanoseconds / kSecond;
  std::int64_t rest = nanoseconds % kSecond;
  if (rest < 0) {
    rest += kSecond;
    --seconds;
  }
  MessageT message;
  message.sec = static_cast<std::int32_t>(seconds);
  message.nanosec = static_cast<std::uint32_t>(rest);
  return message;
}

}  // namespace

Duration Duration::from_rmw_time(rmw_time_t time)
{
  const auto most = static_cast<std::uint64_t>(detail::kInfinite);
  if (time.sec > most / 1000000000) {return from_nanoseconds(detail::kInfinite);}
  return from_nanoseconds(
    static_cast<std::int64_t>(std::min(most, time.sec * 1000000000 + time.nsec)));
}

rmw_time_t Duration::to_rmw_time() const
{
  if (nanoseconds_ < 0) {throw std::runtime_error("rmw_time_t cannot be negative");}
  const auto all = static_cast<std::uint64_t>(nanoseconds_);
  return {all / 1000000000, all % 1000000000};
}

Duration::operator builtin_interfaces::msg::Duration() const
{
  // Beyond the limits of a message, the values are those of upstream.
  const std::int64_t seconds = nanoseconds_ / kSecond;
  builtin_interfaces::msg::Duration message;
  if (seconds > INT32_MAX) {
    message.sec = INT32_MAX;
    message.nanosec = UINT32_MAX;
    return message;
  }
  if (seconds <= INT32_MIN) {
    message.sec = INT32_MIN;
    return message;
  }
  return split<builtin_interfaces::msg::Duration>(nanoseconds_);
}

Duration Duration::operator+(const Duration & other) const
{
  return from_nanoseconds(add(nanoseconds_, other.nanoseconds_));
}

Duration Duration::operator-(const Duration & other) const
{
  return from_nanoseconds(subtract(nanoseconds_, other.nanoseconds_));
}

Duration Duration::operator*(double scale) const
{
  if (!std::isfinite(scale)) {throw std::runtime_error("abnormal scale in rclcpp::Duration");}
  const auto product = static_cast<long double>(nanoseconds_) * static_cast<long double>(scale);
  if (product > static_cast<long double>(INT64_MAX)) {
    throw std::overflow_error("duration scaling leads to int64_t overflow");
  }
  if (product < static_cast<long double>(INT64_MIN)) {
    throw std::underflow_error("duration scaling leads to int64_t underflow");
  }
  return from_nanoseconds(static_cast<std::int64_t>(product));
}

builtin_interfaces::msg::Time operator+(
  const builtin_interfaces::msg::Time & time, const Duration & duration)
{
  return Time(time) + duration;
}

builtin_interfaces::msg::Time operator-(
  const builtin_interfaces::msg::Time & time, const Duration & duration)
{
  return Time(time) - duration;
}

Time::Time(std::int32_t seconds, std::uint32_t nanoseconds, rcl_clock_type_t clock)
: nanoseconds_(seconds * kSecond + nanoseconds), clock_(clock)
{
  if (seconds < 0) {throw std::runtime_error("cannot store a negative time point in rclcpp::Time");}
}

Time::operator builtin_interfaces::msg::Time() const
{
  return split<builtin_interfaces::msg::Time>(nanoseconds_);
}

int Time::compare(const Time & other) const
{
  if (clock_ != other.clock_) {
    throw std::runtime_error("can't compare times with different time sources");
  }
  return nanoseconds_ < other.nanoseconds_ ? -1 : nanoseconds_ > other.nanoseconds_;
}

Duration Time::operator-(const Time & other) const
{
  if (clock_ != other.clock_) {
    throw std::runtime_error("can't subtract times with different time sources");
  }
  return Duration::from_nanoseconds(subtract(nanoseconds_, other.nanoseconds_));
}

Time Time::operator+(const Duration & duration) const
{
  return Time(add(nanoseconds_, duration.nanoseconds()), clock_);
}

Time Time::operator-(const Duration & duration) const
{
  return Time(subtract(nanoseconds_, duration.nanoseconds()), clock_);
}

}  // namespace rclcpp
