// A program that serves the transforms of /tf and /tf_static to BufferClients.
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/buffer.hpp"
#include "tf2_ros/buffer_server.hpp"
#include "tf2_ros/transform_listener.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<rclcpp::Node>("tf_buffer");
  const double seconds = node->declare_parameter("buffer_size", 120.0);
  tf2_ros::Buffer buffer(node->get_clock(), tf2::durationFromSec(seconds));
  tf2_ros::TransformListener listener(buffer, node, false);
  buffer.setUsingDedicatedThread(true);
  const tf2_ros::BufferServer server(buffer, node, "tf2_buffer_server");
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
