// Publishes on /poured at every /go. Arguments: bytes in a message, messages.
#include <memory>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int8_multi_array.hpp"

using std_msgs::msg::UInt8MultiArray;

int main(int argc, char * argv[])
{
  const auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  const auto count = std::stoul(words.at(2));
  UInt8MultiArray message;
  message.data.resize(std::stoul(words.at(1)));

  auto node = std::make_shared<rclcpp::Node>("pour");
  auto publisher = node->create_publisher<UInt8MultiArray>(
    "poured", rclcpp::QoS(rclcpp::KeepAll()));
  auto subscription = node->create_subscription<UInt8MultiArray>(
    "go", 1, [&](const UInt8MultiArray &) {
      for (auto left = count; left-- > 0; ) {publisher->publish(message);}
    });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
