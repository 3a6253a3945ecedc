// Publishes a message a second, and prints each that it hears.
#include <chrono>
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("tick");
  auto publisher = node->create_publisher<std_msgs::msg::String>("ticks", 10);
  auto timer = node->create_wall_timer(
    1s, [&]() {
      std_msgs::msg::String message;
      message.data = "tick";
      publisher->publish(message);
    });
  auto subscription = node->create_subscription<std_msgs::msg::String>(
    "ticks", 10, [&](const std_msgs::msg::String & message) {
      RCLCPP_INFO(node->get_logger(), "I heard: '%s'", message.data.c_str());
    });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
