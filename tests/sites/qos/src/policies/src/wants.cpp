// Wants just what is offered, and tells every event.
#include <chrono>
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("wants");
  const auto logger = node->get_logger();
  rclcpp::SubscriptionOptions options;
  options.event_callbacks.deadline_callback = [&](rclcpp::QOSDeadlineRequestedInfo & event) {
      RCLCPP_INFO_ONCE(logger, "deadline missed %d", event.total_count_change);
    };
  options.event_callbacks.liveliness_callback = [&](rclcpp::QOSLivelinessChangedInfo & event) {
      RCLCPP_INFO(logger, "alive %d, not alive %d", event.alive_count, event.not_alive_count);
    };
  options.event_callbacks.matched_callback = [&](rclcpp::MatchedInfo & event) {
      RCLCPP_INFO(logger, "matched %zu, %+d", event.current_count, event.current_count_change);
    };
  const auto qos = rclcpp::QoS(5).deadline(1s).liveliness(rclcpp::LivelinessPolicy::ManualByTopic)
    .liveliness_lease_duration(1s);
  auto subscription = node->create_subscription<std_msgs::msg::String>(
    "vitals", qos, [&](const std_msgs::msg::String &) {RCLCPP_INFO_ONCE(logger, "heard");},
    options);
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
