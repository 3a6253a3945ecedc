// Publishes a number on each of ten topics, a thousand times a second.
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/float64.hpp"

using namespace std::chrono_literals;
using std_msgs::msg::Float64;

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("wave");
  std::vector<rclcpp::Publisher<Float64>::SharedPtr> publishers;
  for (int n = 0; n < 10; ++n) {
    publishers.push_back(node->create_publisher<Float64>("/wave" + std::to_string(n), 10));
  }
  int step = 0;
  auto timer = node->create_wall_timer(
    1ms, [&]() {
      ++step;
      for (std::size_t n = 0; n < publishers.size(); ++n) {
        Float64 message;
        message.data = std::sin(step / (50.0 * (n + 1)));
        publishers[n]->publish(message);
      }
    });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
