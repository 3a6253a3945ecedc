#include "rclcpp/time.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "rclcpp/clock.hpp"
#include "rclcpp/detail/platform.hpp"
#include "rclcpp/rate.hpp"
#include "rclcpp/timer.hpp"
#include "rclcpp/utilities.hpp"

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

double milliseconds(std::chrono::nanoseconds duration)
{
  return static_cast<double>(duration.count()) / 1e6;
}

std::chrono::nanoseconds nanoseconds(double milliseconds)
{
  return std::chrono::nanoseconds(static_cast<std::int64_t>(milliseconds * 1e6));
}

}  // namespace

Duration Duration::from_rmw_time(rmw_time_t time)
{
  const auto most = static_cast<std::uint64_t>(max().nanoseconds());
  if (time.sec > most / 1000000000) {return max();}
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

Time Clock::now() const {return Time(nanoseconds(detail::now()).count(), clock_);}

bool Clock::sleep_for(const Duration & duration) const
{
  return rclcpp::sleep_for(std::chrono::nanoseconds(duration.nanoseconds()));
}

bool Clock::sleep_until(const Time & until) const {return sleep_for(until - now());}

TimerBase::TimerBase(
  std::chrono::nanoseconds period, std::function<void(TimerBase &)> callback, bool autostart)
: period_(milliseconds(period)), next_(detail::now() + period_), canceled_(!autostart),
  callback_(std::move(callback))
{
  if (period_ < 0) {throw std::invalid_argument("timer period cannot be negative");}
}

void TimerBase::cancel() {canceled_ = true;}

void TimerBase::reset()
{
  canceled_ = false;
  next_ = detail::now() + period_;
}

bool TimerBase::is_ready() const {return !canceled_ && detail::now() >= next_;}

std::chrono::nanoseconds TimerBase::time_until_trigger() const
{
  return canceled_ ? std::chrono::nanoseconds::max() : nanoseconds(next_ - detail::now());
}

void TimerBase::execute()
{
  const double now = detail::now();
  next_ += period_;
  if (next_ < now) {
    const double missed = period_ > 0 ? static_cast<double>(
      static_cast<std::int64_t>((now - next_) / period_)) + 1 : 0;
    next_ = period_ > 0 ? next_ + missed * period_ : now;
  }
  callback_(*this);
}

Rate::Rate(double hertz)
: Rate(nanoseconds(1e3 / hertz))
{
  if (!(hertz > 0)) {throw std::invalid_argument("rate must be greater than 0");}
}

Rate::Rate(std::chrono::nanoseconds period)
: period_(period), last_(detail::now())
{
  if (period_.count() <= 0) {throw std::invalid_argument("period must be greater than 0");}
}

bool Rate::sleep()
{
  const double period = milliseconds(period_);
  const double now = detail::now();
  const double next = last_ + period;
  if (next <= now) {
    // Late by more than a period: start anew instead of hurrying after.
    last_ = now > next + period ? now : next;
    return false;
  }
  last_ = next;
  return sleep_for(nanoseconds(next - now));
}

void Rate::reset() {last_ = detail::now();}

}  // namespace rclcpp
