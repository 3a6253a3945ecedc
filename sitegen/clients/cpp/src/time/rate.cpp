#include "rclcpp/rate.hpp"

#include <stdexcept>
#include <utility>

namespace rclcpp
{

namespace
{

Duration period_of(double hertz)
{
  if (!(hertz > 0)) {throw std::invalid_argument("rate must be greater than 0");}
  return Duration::from_seconds(1.0 / hertz);
}

}  // namespace

Rate::Rate(double hertz, Clock::SharedPtr clock)
: Rate(period_of(hertz), std::move(clock))
{
}

Rate::Rate(const Duration & period, Clock::SharedPtr clock)
: clock_(std::move(clock)), period_(period), last_(clock_->now())
{
  if (period_.nanoseconds() <= 0) {throw std::invalid_argument("period must be greater than 0");}
}

bool Rate::sleep()
{
  const Time now = clock_->now();
  // After a jump back in time, each period begins with a call, as upstream.
  const Time next = (now < last_ ? now : last_) + period_;
  last_ = last_ + period_;
  if (next <= now) {
    // Late by more than a period: do not catch up.
    if (now > next + period_) {last_ = now + period_;}
    return false;
  }
  // Stop may have arrived after the loop called ok(): not an error.
  return contexts::get_global_default_context()->is_valid() && clock_->sleep_for(next - now);
}

void Rate::reset() {last_ = clock_->now();}

}  // namespace rclcpp
