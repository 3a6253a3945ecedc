// Topic statistics of a subscription: the age and the period of messages.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>

#include "rclcpp/clock.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp/timer.hpp"
#include "rclcpp/topic_statistics_state.hpp"
#include "statistics_msgs/msg/metrics_message.hpp"
#include "statistics_msgs/msg/statistic_data_type.hpp"

namespace rclcpp
{
namespace detail
{

namespace
{

using Metrics = statistics_msgs::msg::MetricsMessage;
using Type = statistics_msgs::msg::StatisticDataType;

/// Mean and variance of a series without storing it (Welford's method).
class Series
{
public:
  void add(double value)
  {
    ++count_;
    const double before = value - mean_;
    mean_ += before / static_cast<double>(count_);
    squares_ += before * (value - mean_);
    least_ = std::min(least_, value);
    most_ = std::max(most_, value);
  }

  void write(Metrics & to) const
  {
    const bool any = count_ > 0;
    const double none = std::nan("");
    const auto point = [&to](std::uint8_t type, double value) {
        statistics_msgs::msg::StatisticDataPoint added;
        added.data_type = type;
        added.data = value;
        to.statistics.push_back(added);
      };
    const auto count = static_cast<double>(count_);
    point(Type::STATISTICS_DATA_TYPE_AVERAGE, any ? mean_ : none);
    point(Type::STATISTICS_DATA_TYPE_MINIMUM, any ? least_ : none);
    point(Type::STATISTICS_DATA_TYPE_MAXIMUM, any ? most_ : none);
    point(Type::STATISTICS_DATA_TYPE_STDDEV, any ? std::sqrt(squares_ / count) : none);
    point(Type::STATISTICS_DATA_TYPE_SAMPLE_COUNT, count);
  }

private:
  std::uint64_t count_ = 0;
  double mean_ = 0;
  double squares_ = 0;
  double least_ = std::numeric_limits<double>::infinity();
  double most_ = -std::numeric_limits<double>::infinity();
};

class TopicStatistics
{
public:
  TopicStatistics(
    node_interfaces::NodeBaseInterface & node, const SubscriptionOptionsBase & options)
  : node_(node.get_name()),
    publisher_(node, options.topic_stats_options.publish_topic, options.topic_stats_options.qos),
    start_(Clock(RCL_SYSTEM_TIME).now())
  {
    auto publish = [this]() {this->publish();};
    timer_ = std::make_shared<WallTimer<decltype(publish)>>(
      timer_period(options.topic_stats_options.publish_period), timer_callback(publish), true);
    node.add(ExecutableKind::kTimer, timer_, options.callback_group);
  }

  void arrived(const rmw_message_info_t & info)
  {
    const auto now = info.received_timestamp;
    if (info.source_timestamp) {ages_.add(milliseconds(now - info.source_timestamp));}
    if (last_) {periods_.add(milliseconds(now - last_));}
    last_ = now;
  }

private:
  static double milliseconds(std::int64_t nanoseconds)
  {
    return static_cast<double>(nanoseconds) / 1e6;
  }

  void publish()
  {
    const auto stop = Clock(RCL_SYSTEM_TIME).now();
    publish("message_age", ages_, stop);
    publish("message_period", periods_, stop);
    ages_ = periods_ = Series();
    last_ = 0;
    start_ = stop;
  }

  void publish(const char * metric, const Series & series, const Time & stop)
  {
    Metrics message;
    message.measurement_source_name = node_;
    message.metrics_source = metric;
    message.unit = "ms";
    message.window_start = start_;
    message.window_stop = stop;
    series.write(message);
    publisher_.publish(message);
  }

  std::string node_;
  Publisher<Metrics> publisher_;
  TimerBase::SharedPtr timer_;
  Time start_;
  std::int64_t last_ = 0;
  Series ages_;
  Series periods_;
};

}  // namespace

Arrival make_topic_statistics(
  node_interfaces::NodeBaseInterface & node, const SubscriptionOptionsBase & options)
{
  if (options.topic_stats_options.publish_period <= std::chrono::milliseconds(0)) {
    throw std::invalid_argument(
            "topic_stats_options.publish_period must be greater than 0, specified value of " +
            std::to_string(options.topic_stats_options.publish_period.count()) + " ms");
  }
  auto statistics = std::make_shared<TopicStatistics>(node, options);
  return [statistics](const rmw_message_info_t & info) {statistics->arrived(info);};
}

}  // namespace detail
}  // namespace rclcpp
