// Publishes on /flood as fast as it can until it is stopped. Argument: bytes in a message.
#include <memory>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int8_multi_array.hpp"

using std_msgs::msg::UInt8MultiArray;

int main(int argc, char * argv[])
{
  const auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("flood");
  auto publisher = node->create_publisher<UInt8MultiArray>("flood", 10);
  UInt8MultiArray message;
  message.data.resize(std::stoul(words.at(1)));
  while (rclcpp::ok()) {
    publisher->publish(message);
    rclcpp::spin_some(node);
  }
  return 0;
}
