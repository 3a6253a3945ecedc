// Transforms point clouds.
#pragma once

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"
#include "sensor_msgs/point_cloud2_iterator.hpp"
#include "tf2/LinearMath/Transform.hpp"
#include "tf2/convert.hpp"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/buffer_interface.hpp"

namespace tf2
{

/// The fields x, y and z are transformed, which must be floats; all others are copied.
template<>
inline void doTransform(
  const sensor_msgs::msg::PointCloud2 & in, sensor_msgs::msg::PointCloud2 & out,
  const geometry_msgs::msg::TransformStamped & transform)
{
  Transform moved;
  fromMsg(transform.transform, moved);
  out = in;
  out.header = transform.header;
  sensor_msgs::PointCloud2Iterator<float> x(out, "x"), y(out, "y"), z(out, "z");
  for (; x != x.end(); ++x, ++y, ++z) {
    const Vector3 point = moved * Vector3(*x, *y, *z);
    *x = static_cast<float>(point.x());
    *y = static_cast<float>(point.y());
    *z = static_cast<float>(point.z());
  }
}

inline sensor_msgs::msg::PointCloud2 toMsg(const sensor_msgs::msg::PointCloud2 & in)
{
  return in;
}
inline void fromMsg(const sensor_msgs::msg::PointCloud2 & in, sensor_msgs::msg::PointCloud2 & out)
{
  out = in;
}

}  // namespace tf2
