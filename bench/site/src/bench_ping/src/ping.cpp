// Sends a message on /ping, waits for its echo on /pong, and so on; prints the time of each round in
// ms. Arguments: bytes in a message, rounds.
#include <chrono>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int8_multi_array.hpp"

using namespace std::chrono_literals;
using std::chrono::steady_clock;
using std_msgs::msg::UInt8MultiArray;

int main(int argc, char * argv[])
{
  const auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  const auto size = std::stoul(words.at(1));
  const auto rounds = std::stoul(words.at(2));

  auto node = std::make_shared<rclcpp::Node>("ping");
  auto publisher = node->create_publisher<UInt8MultiArray>("ping", 10);
  UInt8MultiArray message;
  message.data.resize(size);
  std::vector<double> times;
  steady_clock::time_point sent;
  const auto send = [&]() {
      sent = steady_clock::now();
      publisher->publish(message);
    };
  auto subscription = node->create_subscription<UInt8MultiArray>(
    "pong", 10, [&](const UInt8MultiArray & echo) {
      times.push_back(std::chrono::duration<double, std::milli>(steady_clock::now() - sent).count());
      if (echo.data.size() != size) {throw std::runtime_error("an echo of another size");}
      if (times.size() < rounds) {
        send();
      } else {
        rclcpp::shutdown();
      }
    });

  while (!publisher->get_subscription_count() || !subscription->get_publisher_count()) {
    rclcpp::sleep_for(1ms);
  }
  rclcpp::sleep_for(50ms);  // the other side hears of this one at its own time
  send();
  rclcpp::spin(node);
  for (const double time : times) {std::printf("%.4f\n", time);}
  return 0;
}
