// Publishes the transforms of fifty robots with six links each, sixty times a second.
#include <chrono>
#include <cmath>
#include <memory>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "tf2_msgs/msg/tf_message.hpp"

using tf2_msgs::msg::TFMessage;

constexpr int kRobots = 50;
constexpr int kLinks = 6;

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("swarm");
  auto publisher = node->create_publisher<TFMessage>("/tf", 100);
  TFMessage message;
  message.transforms.resize(kRobots * kLinks);
  int step = 0;
  auto timer = node->create_wall_timer(
    std::chrono::microseconds(1000000 / 60), [&]() {
      ++step;
      for (int n = 0; n < kRobots * kLinks; ++n) {
        const int robot = n / kLinks, link = n % kLinks;
        const std::string prefix = "r" + std::to_string(robot) + "/link";
        auto & one = message.transforms[n];
        one.header.stamp = node->now();
        one.header.frame_id = link ? prefix + std::to_string(link - 1) : "map";
        one.child_frame_id = prefix + std::to_string(link);
        if (link == 0) {
          one.transform.translation.x = 2.0 * (robot % 10) - 9;
          one.transform.translation.y = 2.0 * (robot / 10) - 4;
        } else {
          one.transform.translation.z = 0.4;
        }
        const double angle = 0.3 * std::sin(0.05 * step + robot);
        one.transform.rotation.x = std::sin(angle / 2);
        one.transform.rotation.w = std::cos(angle / 2);
      }
      publisher->publish(message);
    });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
