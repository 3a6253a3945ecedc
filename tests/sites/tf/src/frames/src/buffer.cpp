// A buffer without a node: what it finds, and what it says of what it does not find.
#include <chrono>
#include <cstdio>
#include <string>

#include "geometry_msgs/msg/point_stamped.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"
#include "sensor_msgs/point_cloud2_iterator.hpp"
#include "tf2/LinearMath/Matrix3x3.h"
#include "tf2/LinearMath/Quaternion.h"
#include "tf2/buffer_core.h"
#include "tf2/exceptions.h"
#include "tf2/utils.h"
#include "tf2_eigen/tf2_eigen.hpp"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_sensor_msgs/tf2_sensor_msgs.hpp"

namespace
{

tf2::TimePoint at(double seconds) {return tf2::timeFromSec(seconds);}

geometry_msgs::msg::TransformStamped transform(
  const std::string & parent, const std::string & child, double seconds, double x, double yaw)
{
  geometry_msgs::msg::TransformStamped message;
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.header.stamp.sec = static_cast<int>(seconds);
  message.header.stamp.nanosec = static_cast<unsigned>((seconds - static_cast<int>(seconds)) * 1e9);
  message.transform.translation.x = x;
  tf2::Quaternion q;
  q.setRPY(0, 0, yaw);
  message.transform.rotation = tf2::toMsg(q);
  return message;
}

void show(const tf2::BufferCore & buffer, const char * to, const char * from, tf2::TimePoint time)
{
  try {
    const auto found = buffer.lookupTransform(to, from, time);
    const auto & t = found.transform.translation;
    std::printf(
      "%s <- %s at %s: %.3f %.3f, yaw %.3f\n", to, from,
      tf2::displayTimePoint(tf2_ros::fromMsg(found.header.stamp)).c_str(), t.x, t.y,
      tf2::getYaw(found.transform.rotation));
  } catch (const tf2::LookupException & error) {
    std::printf("LookupException: %s\n", error.what());
  } catch (const tf2::ConnectivityException & error) {
    std::printf("ConnectivityException: %s\n", error.what());
  } catch (const tf2::ExtrapolationException & error) {
    std::printf("ExtrapolationException: %s\n", error.what());
  } catch (const tf2::TransformException & error) {
    std::printf("TransformException: %s\n", error.what());
  }
}

}  // namespace

int main()
{
  tf2::BufferCore buffer(std::chrono::seconds(10));
  buffer.setTransform(transform("world", "base", 1, 0, 0), "test");
  buffer.setTransform(transform("world", "base", 3, 2, M_PI / 2), "test");
  buffer.setTransform(transform("base", "laser", 0, 0.5, M_PI), "test", true);
  buffer.setTransform(transform("world", "other", 2, -1, 0), "test");
  buffer.setTransform(transform("far", "away", 2, -1, 0), "test");
  show(buffer, "world", "base", at(2));
  show(buffer, "world", "base", tf2::TimePointZero);
  show(buffer, "base", "world", at(3));
  show(buffer, "world", "laser", at(3));
  show(buffer, "laser", "world", at(3));
  show(buffer, "other", "laser", at(2));
  show(buffer, "other", "laser", tf2::TimePointZero);
  show(buffer, "base", "base", at(9));
  show(buffer, "world", "base", at(4));
  show(buffer, "world", "base", at(0.5));
  show(buffer, "other", "laser", at(2.5));
  show(buffer, "world", "nowhere", at(2));
  show(buffer, "world", "away", at(2));
  show(buffer, "/world", "base", at(2));
  show(buffer, "", "base", at(2));
  const auto fixed = buffer.lookupTransform("base", at(3), "base", at(1), "world");
  std::printf(
    "moved %.3f %.3f\n", fixed.transform.translation.x, fixed.transform.translation.y);
  std::string error;
  std::printf("can %d\n", buffer.canTransform("world", "laser", at(2), &error));
  std::printf("can %d: ", buffer.canTransform("world", "nowhere", at(2), &error));
  std::printf("%s\n", error.c_str());
  std::printf("taken %d\n", buffer.setTransform(transform("a", "a", 1, 0, 0), "test"));
  std::printf("taken %d\n", buffer.setTransform(transform("world", "base", -20, 0, 0), "test"));
  std::printf("%s", buffer.allFramesAsString().c_str());
  std::printf("%s", buffer.allFramesAsYAML().c_str());

  geometry_msgs::msg::PoseStamped pose, moved;
  pose.header.frame_id = "base";
  pose.pose.position.x = 1;
  pose.pose.orientation.w = 1;
  tf2::doTransform(pose, moved, buffer.lookupTransform("world", "base", at(3)));
  std::printf(
    "pose %s %.3f %.3f yaw %.3f\n", moved.header.frame_id.c_str(), moved.pose.position.x,
    moved.pose.position.y, tf2::getYaw(moved.pose.orientation));
  tf2::Transform as_tf;
  tf2::fromMsg(moved.pose, as_tf);
  double roll, pitch, yaw;
  as_tf.getBasis().getRPY(roll, pitch, yaw);
  std::printf("as tf %.3f %.3f %.3f\n", roll, pitch, yaw);
  geometry_msgs::msg::Vector3 vector;
  tf2::convert(as_tf.getOrigin(), vector);
  std::printf("converted %.3f %.3f\n", vector.x, vector.y);

  const tf2::Stamped<Eigen::Vector3d> point(Eigen::Vector3d(1, 0, 0), at(3), "base");
  tf2::Stamped<Eigen::Vector3d> there;
  const auto turned = buffer.lookupTransform("world", "base", at(3));
  tf2::doTransform(point, there, turned);
  const Eigen::Isometry3d back = tf2::transformToEigen(turned).inverse();
  geometry_msgs::msg::Point as_message;
  tf2::convert(Eigen::Vector3d(back * there), as_message);
  std::printf(
    "of Eigen %.3f %.3f in %s, back %.3f %.3f\n", there.x(), there.y(), there.frame_id_.c_str(),
    as_message.x, as_message.y);

  sensor_msgs::msg::PointCloud2 cloud, around;
  cloud.header.frame_id = "base";
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(2, "xyz", "rgb");
  modifier.resize(2);
  sensor_msgs::PointCloud2Iterator<float> x(cloud, "x");
  x[0] = x[1] = x[2] = 0;
  ++x;
  x[0] = 1;
  x[1] = x[2] = 3;
  tf2::doTransform(cloud, around, turned);
  sensor_msgs::PointCloud2ConstIterator<float> last(around, "x");
  ++last;
  std::printf(
    "cloud in %s: %.3f %.3f %.3f of %zu bytes\n", around.header.frame_id.c_str(), last[0], last[1],
    last[2], around.data.size());

  buffer.addTransformableRequest(
    [](auto, const auto & to, const auto & from, auto, auto result) {
      std::printf(
        "%s <- %s is %s\n", to.c_str(), from.c_str(),
        result == tf2::TransformAvailable ? "there" : "lost");
    }, "world", "late", at(5));
  buffer.setTransform(transform("world", "late", 4.5, 0, 0), "test");
  buffer.setTransform(transform("world", "late", 5.5, 0, 0), "test");
  return 0;
}
