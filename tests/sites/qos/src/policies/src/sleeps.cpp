// Wants all, and takes nothing.
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/int32.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("sleeps");
  auto subscription = node->create_subscription<std_msgs::msg::Int32>(
    "wine", rclcpp::QoS(rclcpp::KeepAll()), [](const std_msgs::msg::Int32 &) {});
  while (rclcpp::ok()) {rclcpp::sleep_for(std::chrono::seconds(1));}
  rclcpp::shutdown();
  return 0;
}
