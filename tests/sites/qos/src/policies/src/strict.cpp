// Wants more than is offered, twice; and another type.
#include <chrono>
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/int32.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("strict");
  const auto logger = node->get_logger();
  const auto ignore = [](const std_msgs::msg::String &) {};
  auto quick = node->create_subscription<std_msgs::msg::String>(
    "vitals", rclcpp::QoS(5).deadline(10ms), ignore);
  rclcpp::SubscriptionOptions options;
  options.event_callbacks.incompatible_qos_callback =
    [&](rclcpp::QOSRequestedIncompatibleQoSInfo & event) {
      RCLCPP_INFO(
        logger, "incompatible %d: %s", event.total_count,
        rclcpp::qos_policy_name_from_kind(event.last_policy_kind).c_str());
    };
  auto durable = node->create_subscription<std_msgs::msg::String>(
    "vitals", rclcpp::QoS(5).transient_local(), ignore, options);
  auto number = node->create_subscription<std_msgs::msg::Int32>(
    "vitals", 5, [](const std_msgs::msg::Int32 &) {});
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
