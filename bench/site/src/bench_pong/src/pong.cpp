// Sends back on /pong what it hears on /ping.
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int8_multi_array.hpp"

using std_msgs::msg::UInt8MultiArray;

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("pong");
  auto publisher = node->create_publisher<UInt8MultiArray>("pong", 10);
  auto subscription = node->create_subscription<UInt8MultiArray>(
    "ping", 10, [&](const UInt8MultiArray & message) {publisher->publish(message);});
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
