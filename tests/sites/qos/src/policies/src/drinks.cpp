// Takes all, and tells when it has: in order and without a gap.
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/int32.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("drinks");
  std::int32_t last = 0;
  auto subscription = node->create_subscription<std_msgs::msg::Int32>(
    "wine", rclcpp::QoS(rclcpp::KeepAll()), [&](const std_msgs::msg::Int32 & message) {
      if (message.data != last + 1) {
        RCLCPP_ERROR(node->get_logger(), "%d after %d", message.data, last);
      }
      last = message.data;
      if (last == 30000) {RCLCPP_INFO(node->get_logger(), "drank all");}
    });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
