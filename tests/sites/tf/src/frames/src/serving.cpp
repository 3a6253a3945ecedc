// A program asks a buffer by an action: its own, while another thread spins.
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/buffer_client.h"
#include "tf2_ros/buffer_server.h"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("serving");
  tf2_ros::Buffer buffer(node->get_clock());
  buffer.setUsingDedicatedThread(true);
  tf2_ros::BufferServer server(buffer, node, "tf2_server");
  tf2_ros::BufferClient client(node, "tf2_server");
  std::thread spinning([&] {rclcpp::spin(node);});
  std::printf("server %d\n", client.waitForServer(tf2::durationFromSec(10)));

  std::string error;
  std::printf("can %d", client.canTransform("map", "base", tf2::TimePointZero, {}, &error));
  std::printf(": %s\n", error.c_str());

  // It comes while the server waits for it.
  std::thread later([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      geometry_msgs::msg::TransformStamped base;
      base.header.frame_id = "map";
      base.child_frame_id = "base";
      base.transform.translation.x = 2;
      base.transform.rotation.w = 1;
      buffer.setTransform(base, "test", true);
    });
  const auto found =
    client.lookupTransform("map", "base", tf2::TimePointZero, tf2::durationFromSec(20));
  later.join();
  std::printf("map <- base: %.1f\n", found.transform.translation.x);
  try {
    client.lookupTransform("map", "nowhere", tf2::TimePointZero);
  } catch (const tf2::LookupException & exception) {
    std::printf("LookupException: %s\n", exception.what());
  }
  rclcpp::shutdown();
  spinning.join();
  return 0;
}
