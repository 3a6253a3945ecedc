#pragma once

#include <cstdint>

#include "message_filters/synchronizer.hpp"

namespace message_filters
{
namespace sync_policies
{

/// See detail::ApproximateMatcher.
template<typename ... Ms>
class ApproximateTime : public PolicyBase<Ms...>
{
public:
  // Not explicit: programs give a synchronizer only the size of its queue.
  ApproximateTime(std::uint32_t queue_size)  // NOLINT(runtime/explicit)
  : matcher_(sizeof...(Ms), queue_size) {}

  void setAgePenalty(double age_penalty) {matcher_.setAgePenalty(age_penalty);}
  void setInterMessageLowerBound(int i, rclcpp::Duration lower_bound)
  {
    matcher_.setInterMessageLowerBound(i, lower_bound);
  }
  void setMaxIntervalDuration(rclcpp::Duration max_interval_duration)
  {
    matcher_.setMaxIntervalDuration(max_interval_duration);
  }

protected:
  template<std::size_t I, class EventT, class SignalT>
  void match(const EventT & event, SignalT & signal)
  {
    matcher_.add(
      I, this->template item<I>(event), [&](const detail::Match & match) {
        this->call(signal, match);
      });
  }

private:
  detail::ApproximateMatcher matcher_;
};

}  // namespace sync_policies
}  // namespace message_filters
