#include "rclcpp/timer.hpp"

#include <stdexcept>
#include <utility>

#include "rclcpp/detail/stacks.hpp"

namespace rclcpp
{

TimerBase::TimerBase(
  Clock::SharedPtr clock, std::chrono::nanoseconds period, Callback callback, bool autostart)
: clock_(std::move(clock)), period_(period.count()),
  next_(clock_->now().nanoseconds() + period_), canceled_(!autostart),
  callback_(std::move(callback))
{
  if (period_ < 0) {throw std::invalid_argument("timer period cannot be negative");}
  detail::wake();  // an executor in another thread may be waiting without this timer
}

void TimerBase::reset()
{
  canceled_ = false;
  next_ = clock_->now().nanoseconds() + period_;
  detail::wake();
}

bool TimerBase::is_ready() const
{
  return !canceled_ && clock_->now().nanoseconds() >= next_;
}

std::chrono::nanoseconds TimerBase::time_until_trigger() const
{
  return canceled_ ? std::chrono::nanoseconds::max() :
         std::chrono::nanoseconds(next_ - clock_->now().nanoseconds());
}

bool TimerBase::exchange_in_use_by_wait_set_state(bool in_use)
{
  return std::exchange(in_use_by_wait_set_, in_use);
}

std::shared_ptr<void> TimerBase::call()
{
  if (canceled_) {return nullptr;}
  const Time now = clock_->now();
  *info_ = {Time(next_, now.get_clock_type()), now};
  next_ += period_;
  if (next_ < now.nanoseconds()) {
    const std::int64_t late = now.nanoseconds() - next_;
    next_ = period_ ? next_ + (late / period_ + 1) * period_ : now.nanoseconds();
  }
  return info_;
}

void TimerBase::execute_callback(const std::shared_ptr<void> &) {callback_(*this, *info_);}

bool TimerBase::execute_one()
{
  if (!is_ready() || !call()) {return false;}
  execute_callback();
  return true;
}

}  // namespace rclcpp
