// Conversions between messages of geometry_msgs and classes of tf2.
#pragma once

#include "geometry_msgs/msg/point.hpp"
#include "geometry_msgs/msg/point32.hpp"
#include "geometry_msgs/msg/point_stamped.hpp"
#include "geometry_msgs/msg/pose.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/pose_with_covariance.hpp"
#include "geometry_msgs/msg/pose_with_covariance_stamped.hpp"
#include "geometry_msgs/msg/quaternion.hpp"
#include "geometry_msgs/msg/quaternion_stamped.hpp"
#include "geometry_msgs/msg/transform.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "geometry_msgs/msg/vector3.hpp"
#include "geometry_msgs/msg/vector3_stamped.hpp"
#include "tf2/LinearMath/Quaternion.hpp"
#include "tf2/LinearMath/Transform.hpp"
#include "tf2/LinearMath/Vector3.hpp"
#include "tf2/convert.hpp"
#include "tf2_ros/buffer_interface.hpp"

namespace tf2
{

// Ordered by use: a type comes after the types that it contains.

inline geometry_msgs::msg::Vector3 toMsg(const Vector3 & in)
{
  geometry_msgs::msg::Vector3 out;
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Vector3 & in, Vector3 & out)
{
  out = Vector3(in.x, in.y, in.z);
}

/// A vector can also be a point: the type of the message decides.
template<class PointT>
PointT & toMsg(const Vector3 & in, PointT & out)
{
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Point & in, Vector3 & out)
{
  out = Vector3(in.x, in.y, in.z);
}
inline void fromMsg(const geometry_msgs::msg::Point32 & in, Vector3 & out)
{
  out = Vector3(in.x, in.y, in.z);
}

inline geometry_msgs::msg::Quaternion toMsg(const Quaternion & in)
{
  geometry_msgs::msg::Quaternion out;
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
  out.w = in.w();
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Quaternion & in, Quaternion & out)
{
  out = Quaternion(in.x, in.y, in.z, in.w);
}

inline geometry_msgs::msg::Transform toMsg(const Transform & in)
{
  geometry_msgs::msg::Transform out;
  out.translation = toMsg(in.getOrigin());
  out.rotation = toMsg(in.getRotation());
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Transform & in, Transform & out)
{
  Quaternion rotation;
  fromMsg(in.rotation, rotation);
  out = Transform(rotation, Vector3(in.translation.x, in.translation.y, in.translation.z));
}

/// A transform can also be a pose.
inline geometry_msgs::msg::Pose & toMsg(const Transform & in, geometry_msgs::msg::Pose & out)
{
  toMsg(in.getOrigin(), out.position);
  out.orientation = toMsg(in.getRotation());
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Pose & in, Transform & out)
{
  Quaternion rotation;
  fromMsg(in.orientation, rotation);
  out = Transform(rotation, Vector3(in.position.x, in.position.y, in.position.z));
}

namespace detail
{

template<class Message, class Data>
Message with_header(const Stamped<Data> & in)
{
  Message out;
  out.header.stamp = tf2_ros::toMsg(in.stamp_);
  out.header.frame_id = in.frame_id_;
  return out;
}

template<class Message, class Data>
void from_header(const Message & in, Stamped<Data> & out)
{
  out.stamp_ = TimePointFromMsg(in.header.stamp);
  out.frame_id_ = in.header.frame_id;
}

}  // namespace detail

inline geometry_msgs::msg::Vector3Stamped toMsg(const Stamped<Vector3> & in)
{
  auto out = detail::with_header<geometry_msgs::msg::Vector3Stamped>(in);
  out.vector = toMsg(static_cast<const Vector3 &>(in));
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Vector3Stamped & in, Stamped<Vector3> & out)
{
  detail::from_header(in, out);
  fromMsg(in.vector, static_cast<Vector3 &>(out));
}
inline geometry_msgs::msg::PointStamped & toMsg(
  const Stamped<Vector3> & in, geometry_msgs::msg::PointStamped & out)
{
  out = detail::with_header<geometry_msgs::msg::PointStamped>(in);
  toMsg(static_cast<const Vector3 &>(in), out.point);
  return out;
}
inline void fromMsg(const geometry_msgs::msg::PointStamped & in, Stamped<Vector3> & out)
{
  detail::from_header(in, out);
  fromMsg(in.point, static_cast<Vector3 &>(out));
}
inline geometry_msgs::msg::QuaternionStamped toMsg(const Stamped<Quaternion> & in)
{
  auto out = detail::with_header<geometry_msgs::msg::QuaternionStamped>(in);
  out.quaternion = toMsg(static_cast<const Quaternion &>(in));
  return out;
}
inline void fromMsg(const geometry_msgs::msg::QuaternionStamped & in, Stamped<Quaternion> & out)
{
  detail::from_header(in, out);
  fromMsg(in.quaternion, static_cast<Quaternion &>(out));
}
inline geometry_msgs::msg::TransformStamped toMsg(const Stamped<Transform> & in)
{
  auto out = detail::with_header<geometry_msgs::msg::TransformStamped>(in);
  out.transform = toMsg(static_cast<const Transform &>(in));
  return out;
}
inline void fromMsg(const geometry_msgs::msg::TransformStamped & in, Stamped<Transform> & out)
{
  detail::from_header(in, out);
  fromMsg(in.transform, static_cast<Transform &>(out));
}
inline geometry_msgs::msg::PoseStamped & toMsg(
  const Stamped<Transform> & in, geometry_msgs::msg::PoseStamped & out)
{
  out = detail::with_header<geometry_msgs::msg::PoseStamped>(in);
  toMsg(static_cast<const Transform &>(in), out.pose);
  return out;
}
inline void fromMsg(const geometry_msgs::msg::PoseStamped & in, Stamped<Transform> & out)
{
  detail::from_header(in, out);
  fromMsg(in.pose, static_cast<Transform &>(out));
}
inline geometry_msgs::msg::PoseWithCovarianceStamped toMsg(
  const WithCovarianceStamped<Transform> & in)
{
  auto out = detail::with_header<geometry_msgs::msg::PoseWithCovarianceStamped>(in);
  toMsg(static_cast<const Transform &>(in), out.pose.pose);
  out.pose.covariance = covarianceNestedToRowMajor(in.cov_mat_);
  return out;
}
inline void fromMsg(
  const geometry_msgs::msg::PoseWithCovarianceStamped & in, WithCovarianceStamped<Transform> & out)
{
  detail::from_header(in, out);
  fromMsg(in.pose.pose, static_cast<Transform &>(out));
  out.cov_mat_ = covarianceRowMajorToNested(in.pose.covariance);
}

// The conversion of a message to itself.
#define TF2_GEOMETRY_MSGS_SAME(Name) \
  inline geometry_msgs::msg::Name toMsg(const geometry_msgs::msg::Name & in) {return in;} \
  inline void fromMsg(const geometry_msgs::msg::Name & in, geometry_msgs::msg::Name & out) \
  { \
    out = in; \
  }
TF2_GEOMETRY_MSGS_SAME(Vector3Stamped)
TF2_GEOMETRY_MSGS_SAME(PointStamped)
TF2_GEOMETRY_MSGS_SAME(PoseStamped)
TF2_GEOMETRY_MSGS_SAME(PoseWithCovarianceStamped)
TF2_GEOMETRY_MSGS_SAME(QuaternionStamped)
TF2_GEOMETRY_MSGS_SAME(TransformStamped)
#undef TF2_GEOMETRY_MSGS_SAME

}  // namespace tf2
