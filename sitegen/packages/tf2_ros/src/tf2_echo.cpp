// tf2_echo SOURCE_FRAME TARGET_FRAME [RATE]: print a transform again and again.
#include <cmath>
#include <cstdio>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "tf2/LinearMath/Matrix3x3.hpp"
#include "tf2_ros/buffer.hpp"
#include "tf2_ros/transform_listener.hpp"

int main(int argc, char ** argv)
{
  const auto arguments = rclcpp::init_and_remove_ros_arguments(argc, argv);
  if (arguments.size() < 3) {
    std::printf("Usage: tf2_echo source_frame target_frame [rate]\n");
    return 1;
  }
  const std::string & source = arguments[1];
  const std::string & target = arguments[2];
  const double frequency = arguments.size() > 3 ? std::stod(arguments[3]) : 1.0;
  auto node = rclcpp::Node::make_shared("tf2_echo");
  tf2_ros::Buffer buffer(node->get_clock());
  tf2_ros::TransformListener listener(buffer);
  rclcpp::Rate rate(frequency);
  std::string why;
  while (rclcpp::ok() &&
    !buffer.canTransform(source, target, tf2::TimePointZero, std::chrono::seconds(1), &why))
  {
    RCLCPP_INFO(
      node->get_logger(), "Waiting for transform %s ->  %s: %s", source.c_str(), target.c_str(),
      why.c_str());
  }
  while (rclcpp::ok()) {
    try {
      const auto found = buffer.lookupTransform(source, target, tf2::TimePointZero);
      const auto & t = found.transform.translation;
      const auto & r = found.transform.rotation;
      const double degrees = 180 / M_PI;
      double yaw, pitch, roll;
      tf2::Matrix3x3(tf2::Quaternion(r.x, r.y, r.z, r.w)).getEulerYPR(yaw, pitch, roll);
      std::printf("At time %d.%u\n", found.header.stamp.sec, found.header.stamp.nanosec);
      std::printf("- Translation: [%.3f, %.3f, %.3f]\n", t.x, t.y, t.z);
      std::printf("- Rotation: in Quaternion (xyzw) [%.3f, %.3f, %.3f, %.3f]\n", r.x, r.y, r.z, r.w);
      std::printf("- Rotation: in RPY (radian) [%.3f, %.3f, %.3f]\n", roll, pitch, yaw);
      std::printf(
        "- Rotation: in RPY (degree) [%.3f, %.3f, %.3f]\n",
        roll * degrees, pitch * degrees, yaw * degrees);
      std::fflush(stdout);
    } catch (const tf2::TransformException & error) {
      std::printf(
        "Failure at %f\nException thrown:%s\nThe current list of frames is:\n%s\n",
        node->now().seconds(), error.what(), buffer.allFramesAsString().c_str());
    }
    rate.sleep();
  }
  return 0;
}
