#include "rclcpp/timer.hpp"

#include <stdexcept>
#include <utility>

#include "rclcpp/detail/stacks.hpp"

namespace rclcpp
{

TimerBase::TimerBase(
  Clock::SharedPtr clock, std::chrono::nanoseconds period, Callback callback, bool autostart)
: clock_(std::move(clock)), period_(period.count()),
  last_(clock_->now().nanoseconds()), next_(last_ + period_), canceled_(!autostart),
  callback_(std::move(callback))
{
  if (period_ < 0) {throw std::invalid_argument("timer period cannot be negative");}
  next_on_clock_ = std::exchange(clock_->state_->timers, this);
  detail::wake();  // an executor in another thread may be waiting without this timer
}

TimerBase::~TimerBase()
{
  TimerBase ** place = &clock_->state_->timers;
  while (*place != this) {place = &(*place)->next_on_clock_;}
  *place = next_on_clock_;
}

void TimerBase::reset()
{
  canceled_ = false;
  next_ = clock_->now().nanoseconds() + period_;
  ++resets_;
  tell_of_resets();
  detail::wake();
}

void TimerBase::set_on_reset_callback(std::function<void(std::size_t)> callback)
{
  if (!callback) {
    throw std::invalid_argument("the callback passed to set_on_reset_callback is not callable");
  }
  on_reset_ = std::move(callback);
  tell_of_resets();
}

void TimerBase::tell_of_resets()
{
  // The callback may remove itself.
  const auto callback = on_reset_;
  if (callback && resets_) {callback(std::exchange(resets_, 0));}
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

std::int64_t TimerBase::time_left() const
{
  const std::int64_t left = time_until_trigger().count();
  return left > 0 && clock_->state_->source ? INT64_MAX : left;
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
  last_ = now.nanoseconds();
  next_ += period_;
  if (next_ <= last_) {
    const std::int64_t late = last_ - next_;
    next_ += period_ ? (late / period_ + 1) * period_ : late;
  }
  return info_;
}

void TimerBase::execute_callback(const std::shared_ptr<void> &) {callback_(*this, *info_);}

void TimerBase::save_left()
{
  // A clock without a message from /clock is at 0, and says nothing about the period.
  if (const std::int64_t now = clock_->time()) {left_ = next_ - now;}
}

void TimerBase::follow_jump(bool source_changed)
{
  const std::int64_t now = clock_->time();
  if (!source_changed) {
    if (now < last_ && now < next_) {
      last_ = now;
      next_ = now + period_;
    }
  } else if (now && left_) {
    // As rcl does, which adds what was left to the last call instead of to now.
    last_ = now - left_;
    next_ = last_ + period_;
    left_ = 0;
  }
}

bool TimerBase::execute_one()
{
  if (!is_ready() || !call()) {return false;}
  execute_callback();
  return true;
}

}  // namespace rclcpp
