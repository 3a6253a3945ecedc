// A program asks the buffer of another one, the buffer_server of tf2_ros.
#include <cstdio>
#include <memory>
#include <thread>

#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/buffer_client.h"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("asking");
  tf2_ros::BufferClient client(node, "tf2_buffer_server");
  std::thread spinning([&] {rclcpp::spin(node);});
  std::printf("server %d\n", client.waitForServer(tf2::durationFromSec(60)));
  const auto found =
    client.lookupTransform("world", "map", tf2::TimePointZero, tf2::durationFromSec(60));
  std::printf("world <- map: %.1f\n", found.transform.translation.x);
  try {
    client.lookupTransform("world", "nowhere", tf2::TimePointZero, tf2::durationFromSec(0.1));
  } catch (const tf2::LookupException & exception) {
    std::printf("LookupException: %s\n", exception.what());
  }
  rclcpp::shutdown();
  spinning.join();
  return 0;
}
