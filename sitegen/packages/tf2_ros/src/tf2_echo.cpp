// tf2_echo SOURCE_FRAME TARGET_FRAME [RATE]: print a transform repeatedly.
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "tf2/LinearMath/Matrix3x3.hpp"
#include "tf2_ros/buffer.hpp"
#include "tf2_ros/transform_listener.hpp"

static void print(const geometry_msgs::msg::TransformStamped & found)
{
  const auto & t = found.transform.translation;
  const auto & r = found.transform.rotation;
  const tf2::Matrix3x3 matrix(tf2::Quaternion(r.x, r.y, r.z, r.w));
  const double degrees = 180 / M_PI;
  double yaw, pitch, roll;
  matrix.getEulerYPR(yaw, pitch, roll);
  std::printf("At time %d.%u\n", found.header.stamp.sec, found.header.stamp.nanosec);
  std::printf("- Translation: [%.3f, %.3f, %.3f]\n", t.x, t.y, t.z);
  std::printf("- Rotation: in Quaternion (xyzw) [%.3f, %.3f, %.3f, %.3f]\n", r.x, r.y, r.z, r.w);
  std::printf("- Rotation: in RPY (radian) [%.3f, %.3f, %.3f]\n", roll, pitch, yaw);
  std::printf(
    "- Rotation: in RPY (degree) [%.3f, %.3f, %.3f]\n",
    roll * degrees, pitch * degrees, yaw * degrees);
  std::printf("- Matrix:\n");
  const double along[] = {t.x, t.y, t.z};
  for (int i = 0; i < 3; ++i) {
    std::printf(" %6.3f %6.3f %6.3f %6.3f\n", matrix[i].x(), matrix[i].y(), matrix[i].z(), along[i]);
  }
  std::printf(" %6.3f %6.3f %6.3f %6.3f\n", 0.0, 0.0, 0.0, 1.0);
}

int main(int argc, char ** argv)
{
  const auto arguments = rclcpp::init_and_remove_ros_arguments(argc, argv);
  if (arguments.size() < 3 || arguments.size() > 4) {
    std::printf("Usage: tf2_echo source_frame target_frame [echo_rate]\n");
    return -1;
  }
  const std::string & source = arguments[1];
  const std::string & target = arguments[2];
  double frequency = 1.0;
  if (arguments.size() == 4) {
    std::size_t size = 0;
    try {
      frequency = std::stod(arguments[3], &size);
    } catch (const std::exception &) {
    }
    if (size == 0 || size != arguments[3].size()) {
      std::fprintf(
        stderr, "Failed to convert rate argument '%s' to a floating-point number\n",
        arguments[3].c_str());
      return 2;
    }
  }
  auto node = rclcpp::Node::make_shared("tf2_echo");
  tf2_ros::Buffer buffer(node->get_clock());
  tf2_ros::TransformListener listener(buffer);
  rclcpp::Rate rate(frequency);
  std::string why;
  while (rclcpp::ok() && !buffer.canTransform(source, target, tf2::TimePoint(), &why)) {
    RCLCPP_INFO_THROTTLE(
      node->get_logger(), *node->get_clock(), 1000, "Waiting for transform %s ->  %s: %s",
      source.c_str(), target.c_str(), why.c_str());
    rate.sleep();
  }
  while (rclcpp::ok()) {
    try {
      print(buffer.lookupTransform(source, target, tf2::TimePointZero));
    } catch (const tf2::TransformException & error) {
      std::printf(
        "Failure at %f\nException thrown:%s\nThe current list of frames is:\n%s\n",
        node->now().seconds(), error.what(), buffer.allFramesAsString().c_str());
    }
    std::fflush(stdout);
    rate.sleep();
  }
  return 0;
}
