// A loop in a thread while main() spins; a loop that only asks whether all is well; Stop ends both.
#include <memory>
#include <thread>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("spinning");
  auto publisher = node->create_publisher<std_msgs::msg::String>("topic", 10);
  int heard = 0;
  auto subscription = node->create_subscription<std_msgs::msg::String>(
    "topic", 10, [&](const std_msgs::msg::String & message) {
      if (++heard == 3) {RCLCPP_INFO(node->get_logger(), "heard %s", message.data.c_str());}
    });
  std::thread loop([&] {
      rclcpp::Rate rate(100.0);
      std_msgs::msg::String message;
      message.data = "from the loop";
      while (rclcpp::ok()) {
        publisher->publish(message);
        rate.sleep();
      }
      RCLCPP_INFO(node->get_logger(), "loop ended");
    });
  std::thread busy([&] {
      while (rclcpp::ok()) {}
      RCLCPP_INFO(node->get_logger(), "busy ended");
    });
  rclcpp::spin(node);
  loop.join();
  busy.join();
  RCLCPP_INFO(node->get_logger(), "all ended");
}
