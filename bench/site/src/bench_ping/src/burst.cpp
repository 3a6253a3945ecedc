// Publishes messages on /burst as fast as it can, until /done says that all arrived; does so twice,
// the first time to warm up, and prints the time of the second in ms. Arguments: bytes in a message,
// messages, and how many sinks hear them (one, if not given).
#include <chrono>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int8_multi_array.hpp"

using namespace std::chrono_literals;
using std::chrono::steady_clock;
using std_msgs::msg::UInt8MultiArray;

int main(int argc, char * argv[])
{
  const auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  const auto size = std::stoul(words.at(1));
  const auto count = std::stoul(words.at(2));
  const auto sinks = words.size() > 3 ? std::stoul(words[3]) : 1;

  auto node = std::make_shared<rclcpp::Node>("burst");
  auto publisher = node->create_publisher<UInt8MultiArray>("burst", rclcpp::QoS(rclcpp::KeepAll()));
  UInt8MultiArray message;
  message.data.resize(size);
  steady_clock::time_point begun;
  const auto send = [&]() {
      begun = steady_clock::now();
      for (auto left = count; left-- > 0; ) {
        message.layout.data_offset = left;
        publisher->publish(message);
      }
    };
  bool warm = false;
  std::size_t ready = 0;
  double time = 0;
  auto subscription = node->create_subscription<UInt8MultiArray>(
    "done", 10, [&](const UInt8MultiArray & done) {
      time = std::chrono::duration<double, std::milli>(steady_clock::now() - begun).count();
      if (done.layout.data_offset != count) {throw std::runtime_error("messages were lost");}
      if (++ready < sinks) {return;}
      ready = 0;
      if (warm) {
        rclcpp::shutdown();
      } else {
        warm = true;
        send();
      }
    });

  while (
    publisher->get_subscription_count() < sinks || subscription->get_publisher_count() < sinks)
  {
    rclcpp::sleep_for(1ms);
  }
  rclcpp::sleep_for(50ms);  // the other side hears of this one at its own time
  send();
  rclcpp::spin(node);
  std::printf("%.4f\n", time);
  return 0;
}
