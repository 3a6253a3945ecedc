// Waits for its writers, says /go, and prints how long it takes (ms) until it has all their messages; does
// so twice, the first time to warm up. Arguments: writers, messages of each.
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int8_multi_array.hpp"

using namespace std::chrono_literals;
using std::chrono::steady_clock;
using std_msgs::msg::UInt8MultiArray;

int main(int argc, char * argv[])
{
  const auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  const auto writers = std::stoul(words.at(1));
  const auto count = std::stoul(words.at(2)) * writers;

  auto node = std::make_shared<rclcpp::Node>("collect");
  auto go = node->create_publisher<UInt8MultiArray>("go", 1);
  std::size_t heard = 0;
  bool warm = false;
  steady_clock::time_point begun;
  const auto start = [&]() {
      heard = 0;
      begun = steady_clock::now();
      go->publish(UInt8MultiArray());
    };
  auto subscription = node->create_subscription<UInt8MultiArray>(
    "poured", rclcpp::QoS(rclcpp::KeepAll()), [&](const UInt8MultiArray &) {
      if (++heard < count) {return;}
      if (warm) {
        std::printf(
          "%.4f\n",
          std::chrono::duration<double, std::milli>(steady_clock::now() - begun).count());
        rclcpp::shutdown();
      } else {
        warm = true;
        start();
      }
    });
  while (subscription->get_publisher_count() < writers || go->get_subscription_count() < writers) {
    rclcpp::sleep_for(1ms);
  }
  rclcpp::sleep_for(50ms);  // the other sides hear of this one at their own time
  start();
  rclcpp::spin(node);
  return 0;
}
