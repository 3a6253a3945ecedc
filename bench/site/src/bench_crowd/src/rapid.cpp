// Publishes ten thousand texts a second.
#include <chrono>
#include <memory>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;
using std_msgs::msg::String;

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("rapid");
  auto publisher = node->create_publisher<String>("/rapid", 100);
  int number = 0;
  auto timer = node->create_wall_timer(
    1ms, [&]() {
      for (int n = 0; n < 10; ++n) {
        String message;
        message.data = "message " + std::to_string(++number);
        publisher->publish(message);
      }
    });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
