#pragma once

#include <tuple>
#include <utility>
#include <vector>

#include "message_filters/synchronizer.hpp"
#include "rclcpp/clock.hpp"

namespace message_filters
{
namespace sync_policies
{

/// See detail::LatestMatcher.
template<typename ... Ms>
class LatestTime : public PolicyBase<Ms...>
{
public:
  /// See detail::LatestMatcher::Weights.
  using RateConfig = std::tuple<double, double, double>;

  LatestTime()
  : LatestTime(std::make_shared<rclcpp::Clock>(RCL_ROS_TIME)) {}
  explicit LatestTime(rclcpp::Clock::SharedPtr clock)
  : matcher_(sizeof...(Ms), std::move(clock)) {}

  void setRateConfig(const RateConfig & config) {setRateConfigPerMessage({config});}
  void setRateConfigPerMessage(const std::vector<RateConfig> & configs)
  {
    std::vector<detail::LatestMatcher::Weights> all;
    for (const auto & [rate, error, margin] : configs) {all.push_back({rate, error, margin});}
    matcher_.set_weights(std::move(all));
  }
  void setClock(rclcpp::Clock::SharedPtr clock) {matcher_.set_clock(std::move(clock));}

protected:
  template<std::size_t I, class EventT, class SignalT>
  void match(const EventT & event, SignalT & signal)
  {
    // Messages need no header: their time is the time of arrival.
    const detail::Item item{
      event.getConstMessage(), event.getReceiptTime(), event.getReceiptTime().nanoseconds()};
    matcher_.add(
      I, item, [&](const detail::Match & match) {this->call(signal, match);});
  }

private:
  detail::LatestMatcher matcher_;
};

}  // namespace sync_policies
}  // namespace message_filters
