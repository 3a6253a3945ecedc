// Takes a tenth of a second for each message of /flood, and prints how old (ms) each was.
#include <chrono>
#include <cstdio>
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int8_multi_array.hpp"

using namespace std::chrono_literals;
using std_msgs::msg::UInt8MultiArray;

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("slow");
  auto subscription = node->create_subscription<UInt8MultiArray>(
    "flood", 1, [&](const UInt8MultiArray &, const rclcpp::MessageInfo & info) {
      const auto sent = info.get_rmw_message_info().source_timestamp;
      std::printf("%.1f\n", static_cast<double>(node->now().nanoseconds() - sent) / 1e6);
      rclcpp::sleep_for(100ms);
    });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
