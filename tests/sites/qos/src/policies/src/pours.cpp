// Publishes as fast as it can, and keeps all; a full subscription makes it wait or fail.
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/int32.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("pours");
  auto publisher = node->create_publisher<std_msgs::msg::Int32>(
    "wine", rclcpp::QoS(rclcpp::KeepAll()));
  while (rclcpp::ok() && publisher->get_subscription_count() == 0) {
    rclcpp::sleep_for(std::chrono::milliseconds(10));
  }
  std_msgs::msg::Int32 message;
  for (message.data = 1; rclcpp::ok() && message.data <= 30000; ++message.data) {
    try {
      publisher->publish(message);
    } catch (const rclcpp::exceptions::RCLError & error) {
      RCLCPP_ERROR(node->get_logger(), "%s", error.what());
      return 0;
    }
  }
  const bool all = publisher->wait_for_all_acked(std::chrono::seconds(60));
  RCLCPP_INFO(node->get_logger(), "poured, all: %d", all);
  rclcpp::shutdown();
  return 0;
}
