// Counts what it hears on /burst; after the last message, which has offset 0, says on /done how many
// there were.
#include <cstdint>
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int8_multi_array.hpp"

using std_msgs::msg::UInt8MultiArray;

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("sink");
  auto publisher = node->create_publisher<UInt8MultiArray>("done", 10);
  std::uint32_t count = 0;
  auto subscription = node->create_subscription<UInt8MultiArray>(
    "burst", rclcpp::QoS(rclcpp::KeepAll()), [&](const UInt8MultiArray & message) {
      ++count;
      if (message.layout.data_offset != 0) {return;}
      UInt8MultiArray done;
      done.layout.data_offset = count;
      publisher->publish(done);
      count = 0;
    });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
