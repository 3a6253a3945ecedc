// Queues that keep nothing, as far as their depth says.
#include <cstdio>
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/int32.hpp"

using std_msgs::msg::Int32;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("zero");
  const auto quiet = node->create_publisher<Int32>("quiet", rclcpp::SystemDefaultsQoS());
  RCLCPP_INFO(node->get_logger(), "nothing yet");
  const auto out = node->create_publisher<Int32>("numbers", rclcpp::QoS(rclcpp::KeepLast(0)));
  int got = 0;
  const auto in = node->create_subscription<Int32>(
    "numbers", 0, [&got](const Int32 & message) {got = message.data;});
  RCLCPP_INFO(node->get_logger(), "depth %zu", rclcpp::QoS(5).keep_last(0).depth());
  while (!out->get_subscription_count()) {rclcpp::spin_some(node);}
  Int32 message;
  message.data = 7;
  out->publish(message);
  while (!got) {rclcpp::spin_some(node);}
  RCLCPP_INFO(node->get_logger(), "got %d", got);
  rclcpp::shutdown();
}
