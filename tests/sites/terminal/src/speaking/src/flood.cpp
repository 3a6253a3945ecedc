// Publishes as fast as it can, with control sequences in its texts.

#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("flood");
  auto publisher = node->create_publisher<std_msgs::msg::String>("flood", rclcpp::QoS(1000).best_effort());
  std_msgs::msg::String message;
  for (int count = 0; rclcpp::ok(); ++count) {
    message.data = "\x1b[2J\x1b]0;owned\x07 " + std::to_string(count);
    for (int each = 0; each < 100; ++each) {
      publisher->publish(message);
    }
    rclcpp::spin_some(node);
  }
  rclcpp::shutdown();
  return 0;
}
