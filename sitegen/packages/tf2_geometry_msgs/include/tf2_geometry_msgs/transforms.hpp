// Transform messages of geometry_msgs to another frame.
#pragma once

#include "geometry_msgs/msg/polygon_stamped.hpp"
#include "geometry_msgs/msg/pose_array.hpp"
#include "geometry_msgs/msg/wrench_stamped.hpp"
#include "tf2/LinearMath/Transform.hpp"
#include "tf2_geometry_msgs/conversions.hpp"

namespace tf2
{
namespace detail
{

inline Transform of(const geometry_msgs::msg::TransformStamped & transform)
{
  Transform found;
  fromMsg(transform.transform, found);
  return found;
}

template<class PointT>
void move(const PointT & in, PointT & out, const Transform & transform)
{
  toMsg(transform(Vector3(in.x, in.y, in.z)), out);
}

inline void turn(
  const geometry_msgs::msg::Vector3 & in, geometry_msgs::msg::Vector3 & out,
  const Transform & transform)
{
  out = toMsg(transform.getBasis() * Vector3(in.x, in.y, in.z));
}

inline void turn(
  const geometry_msgs::msg::Quaternion & in, geometry_msgs::msg::Quaternion & out,
  const Transform & transform)
{
  Quaternion rotation;
  fromMsg(in, rotation);
  out = toMsg(transform.getRotation() * rotation);
}

inline void move(
  const geometry_msgs::msg::Pose & in, geometry_msgs::msg::Pose & out, const Transform & transform)
{
  move(in.position, out.position, transform);
  turn(in.orientation, out.orientation, transform);
}

inline std::array<double, 36> turned(
  const std::array<double, 36> & covariance, const Matrix3x3 & rotation)
{
  // R C Rᵀ for each of the four 3x3 blocks.
  std::array<double, 36> out;
  for (int block = 0; block < 4; ++block) {
    const int start = block / 2 * 18 + block % 2 * 3;
    Matrix3x3 part;
    for (int i = 0; i < 9; ++i) {part[i / 3][i % 3] = covariance[start + i / 3 * 6 + i % 3];}
    part = (rotation * part).timesTranspose(rotation);
    for (int i = 0; i < 9; ++i) {out[start + i / 3 * 6 + i % 3] = part[i / 3][i % 3];}
  }
  return out;
}

}  // namespace detail

inline geometry_msgs::msg::PoseWithCovariance::_covariance_type transformCovariance(
  const geometry_msgs::msg::PoseWithCovariance::_covariance_type & covariance,
  const Transform & transform)
{
  return detail::turned(covariance, transform.getBasis());
}

// `T` is a message, `act` the statements that compute t_out from t_in with `transform`.
#define TF2_GEOMETRY_MSGS_TRANSFORM(T, act) \
  template<> \
  inline void doTransform( \
    const geometry_msgs::msg::T & t_in, geometry_msgs::msg::T & t_out, \
    const geometry_msgs::msg::TransformStamped & stamped) \
  { \
    const Transform transform = detail::of(stamped); \
    act \
  }
// The same for a message with a header, which is replaced by that of the transform.
#define TF2_GEOMETRY_MSGS_TRANSFORM_STAMPED(T, act) \
  TF2_GEOMETRY_MSGS_TRANSFORM( \
    T, \
    act \
    t_out.header.stamp = stamped.header.stamp; \
    t_out.header.frame_id = stamped.header.frame_id;)

TF2_GEOMETRY_MSGS_TRANSFORM(Vector3, detail::turn(t_in, t_out, transform);)
TF2_GEOMETRY_MSGS_TRANSFORM_STAMPED(
  Vector3Stamped, detail::turn(t_in.vector, t_out.vector, transform);)
TF2_GEOMETRY_MSGS_TRANSFORM(Point, detail::move(t_in, t_out, transform);)
TF2_GEOMETRY_MSGS_TRANSFORM(Point32, detail::move(t_in, t_out, transform);)
TF2_GEOMETRY_MSGS_TRANSFORM_STAMPED(
  PointStamped, detail::move(t_in.point, t_out.point, transform);)
TF2_GEOMETRY_MSGS_TRANSFORM(Quaternion, detail::turn(t_in, t_out, transform);)
TF2_GEOMETRY_MSGS_TRANSFORM_STAMPED(
  QuaternionStamped, detail::turn(t_in.quaternion, t_out.quaternion, transform);)
TF2_GEOMETRY_MSGS_TRANSFORM(Pose, detail::move(t_in, t_out, transform);)
TF2_GEOMETRY_MSGS_TRANSFORM_STAMPED(PoseStamped, detail::move(t_in.pose, t_out.pose, transform);)
TF2_GEOMETRY_MSGS_TRANSFORM(
  PoseWithCovariance,
  detail::move(t_in.pose, t_out.pose, transform);
  t_out.covariance = transformCovariance(t_in.covariance, transform);)
TF2_GEOMETRY_MSGS_TRANSFORM_STAMPED(
  PoseWithCovarianceStamped,
  detail::move(t_in.pose.pose, t_out.pose.pose, transform);
  t_out.pose.covariance = transformCovariance(t_in.pose.covariance, transform);)
TF2_GEOMETRY_MSGS_TRANSFORM_STAMPED(
  PoseArray,
  t_out.poses.resize(t_in.poses.size());
  for (std::size_t i = 0; i < t_in.poses.size(); ++i) {
    detail::move(t_in.poses[i], t_out.poses[i], transform);
  })
TF2_GEOMETRY_MSGS_TRANSFORM(
  Polygon,
  t_out.points.resize(t_in.points.size());
  for (std::size_t i = 0; i < t_in.points.size(); ++i) {
    detail::move(t_in.points[i], t_out.points[i], transform);
  })
TF2_GEOMETRY_MSGS_TRANSFORM_STAMPED(
  PolygonStamped, (void)transform; doTransform(t_in.polygon, t_out.polygon, stamped);)
TF2_GEOMETRY_MSGS_TRANSFORM(
  Transform,
  Transform inner;
  fromMsg(t_in, inner);
  t_out = toMsg(transform * inner);)
TF2_GEOMETRY_MSGS_TRANSFORM_STAMPED(
  TransformStamped,
  t_out.child_frame_id = t_in.child_frame_id;
  Transform inner;
  fromMsg(t_in.transform, inner);
  t_out.transform = toMsg(transform * inner);)
TF2_GEOMETRY_MSGS_TRANSFORM(
  Wrench,
  detail::turn(t_in.force, t_out.force, transform);
  detail::turn(t_in.torque, t_out.torque, transform);)
TF2_GEOMETRY_MSGS_TRANSFORM_STAMPED(
  WrenchStamped,
  detail::turn(t_in.wrench.force, t_out.wrench.force, transform);
  detail::turn(t_in.wrench.torque, t_out.wrench.torque, transform);)

#undef TF2_GEOMETRY_MSGS_TRANSFORM_STAMPED
#undef TF2_GEOMETRY_MSGS_TRANSFORM

}  // namespace tf2
