// Conversions between messages of geometry_msgs and types of Eigen.
#pragma once

#include <Eigen/Geometry>

#include "geometry_msgs/msg/point_stamped.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/quaternion_stamped.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "geometry_msgs/msg/vector3_stamped.hpp"
#include "geometry_msgs/msg/wrench.hpp"
#include "tf2/convert.hpp"
#include "tf2_ros/buffer_interface.hpp"

namespace tf2
{

// Ordered by use: a type comes after the types that it contains.

inline geometry_msgs::msg::Point toMsg(const Eigen::Vector3d & in)
{
  geometry_msgs::msg::Point out;
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
  return out;
}
inline geometry_msgs::msg::Vector3 & toMsg(
  const Eigen::Vector3d & in, geometry_msgs::msg::Vector3 & out)
{
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
  return out;
}
inline geometry_msgs::msg::Vector3 toMsg2(const Eigen::Vector3d & in)
{
  geometry_msgs::msg::Vector3 out;
  return toMsg(in, out);
}
inline void fromMsg(const geometry_msgs::msg::Point & in, Eigen::Vector3d & out)
{
  out = {in.x, in.y, in.z};
}
inline void fromMsg(const geometry_msgs::msg::Vector3 & in, Eigen::Vector3d & out)
{
  out = {in.x, in.y, in.z};
}

inline geometry_msgs::msg::Quaternion toMsg(const Eigen::Quaterniond & in)
{
  geometry_msgs::msg::Quaternion out;
  out.w = in.w();
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Quaternion & in, Eigen::Quaterniond & out)
{
  out = Eigen::Quaterniond(in.w, in.x, in.y, in.z);
}

namespace detail
{

template<class TransformT>
geometry_msgs::msg::Pose pose_of(const TransformT & in)
{
  geometry_msgs::msg::Pose out;
  out.position = toMsg(Eigen::Vector3d(in.translation()));
  Eigen::Quaterniond rotation(in.linear());
  // Of the two quaternions for the same rotation, return the one with a positive w.
  if (rotation.w() < 0) {rotation.coeffs() *= -1;}
  out.orientation = toMsg(rotation);
  return out;
}

inline Eigen::Isometry3d transform_of(
  const Eigen::Vector3d & translation, const Eigen::Quaterniond & rotation)
{
  return Eigen::Translation3d(translation) * rotation;
}

}  // namespace detail

inline geometry_msgs::msg::Pose toMsg(const Eigen::Affine3d & in) {return detail::pose_of(in);}
inline geometry_msgs::msg::Pose toMsg(const Eigen::Isometry3d & in) {return detail::pose_of(in);}
inline void fromMsg(const geometry_msgs::msg::Pose & in, Eigen::Isometry3d & out)
{
  Eigen::Vector3d position;
  Eigen::Quaterniond orientation;
  fromMsg(in.position, position);
  fromMsg(in.orientation, orientation);
  out = detail::transform_of(position, orientation);
}
inline void fromMsg(const geometry_msgs::msg::Pose & in, Eigen::Affine3d & out)
{
  Eigen::Isometry3d transform;
  fromMsg(in, transform);
  out = transform;
}

/// The first three elements are the linear part of a twist, or the force of a wrench.
inline geometry_msgs::msg::Twist toMsg(const Eigen::Matrix<double, 6, 1> & in)
{
  geometry_msgs::msg::Twist out;
  toMsg(Eigen::Vector3d(in.head<3>()), out.linear);
  toMsg(Eigen::Vector3d(in.tail<3>()), out.angular);
  return out;
}
inline geometry_msgs::msg::Wrench & toMsg(
  const Eigen::Matrix<double, 6, 1> & in, geometry_msgs::msg::Wrench & out)
{
  toMsg(Eigen::Vector3d(in.head<3>()), out.force);
  toMsg(Eigen::Vector3d(in.tail<3>()), out.torque);
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Twist & in, Eigen::Matrix<double, 6, 1> & out)
{
  out << in.linear.x, in.linear.y, in.linear.z, in.angular.x, in.angular.y, in.angular.z;
}
inline void fromMsg(const geometry_msgs::msg::Wrench & in, Eigen::Matrix<double, 6, 1> & out)
{
  out << in.force.x, in.force.y, in.force.z, in.torque.x, in.torque.y, in.torque.z;
}

inline Eigen::Isometry3d transformToEigen(const geometry_msgs::msg::Transform & in)
{
  Eigen::Vector3d translation;
  Eigen::Quaterniond rotation;
  fromMsg(in.translation, translation);
  fromMsg(in.rotation, rotation);
  return detail::transform_of(translation, rotation);
}
inline Eigen::Isometry3d transformToEigen(const geometry_msgs::msg::TransformStamped & in)
{
  return transformToEigen(in.transform);
}
inline geometry_msgs::msg::TransformStamped eigenToTransform(const Eigen::Isometry3d & in)
{
  geometry_msgs::msg::TransformStamped out;
  toMsg(Eigen::Vector3d(in.translation()), out.transform.translation);
  out.transform.rotation = toMsg(Eigen::Quaterniond(in.linear()));
  return out;
}
inline geometry_msgs::msg::TransformStamped eigenToTransform(const Eigen::Affine3d & in)
{
  Eigen::Isometry3d transform;
  transform.matrix() = in.matrix();
  return eigenToTransform(transform);
}

// `T` is a type of Eigen, `Message` its stamped message, `part` the field that contains it.
#define TF2_EIGEN_STAMPED(T, Message, part) \
  inline geometry_msgs::msg::Message toMsg(const Stamped<T> & in) \
  { \
    geometry_msgs::msg::Message out; \
    out.header.stamp = tf2_ros::toMsg(in.stamp_); \
    out.header.frame_id = in.frame_id_; \
    out.part = toMsg(static_cast<const T &>(in)); \
    return out; \
  } \
  inline void fromMsg(const geometry_msgs::msg::Message & in, Stamped<T> & out) \
  { \
    out.stamp_ = TimePointFromMsg(in.header.stamp); \
    out.frame_id_ = in.header.frame_id; \
    fromMsg(in.part, static_cast<T &>(out)); \
  }

TF2_EIGEN_STAMPED(Eigen::Vector3d, PointStamped, point)
TF2_EIGEN_STAMPED(Eigen::Quaterniond, QuaternionStamped, quaternion)
TF2_EIGEN_STAMPED(Eigen::Affine3d, PoseStamped, pose)
TF2_EIGEN_STAMPED(Eigen::Isometry3d, PoseStamped, pose)

#undef TF2_EIGEN_STAMPED

template<>
inline void doTransform(
  const Eigen::Vector3d & in, Eigen::Vector3d & out,
  const geometry_msgs::msg::TransformStamped & transform)
{
  out = transformToEigen(transform) * in;
}
template<>
inline void doTransform(
  const Eigen::Quaterniond & in, Eigen::Quaterniond & out,
  const geometry_msgs::msg::TransformStamped & transform)
{
  out = Eigen::Quaterniond(transformToEigen(transform).linear()) * in;
}
template<>
inline void doTransform(
  const Eigen::Affine3d & in, Eigen::Affine3d & out,
  const geometry_msgs::msg::TransformStamped & transform)
{
  out = Eigen::Affine3d(transformToEigen(transform)) * in;
}
template<>
inline void doTransform(
  const Eigen::Isometry3d & in, Eigen::Isometry3d & out,
  const geometry_msgs::msg::TransformStamped & transform)
{
  out = transformToEigen(transform) * in;
}

namespace detail
{

template<class T>
void do_stamped(
  const Stamped<T> & in, Stamped<T> & out, const geometry_msgs::msg::TransformStamped & transform)
{
  T moved;
  doTransform(static_cast<const T &>(in), moved, transform);
  const auto & header = transform.header;
  out = Stamped<T>(moved, TimePointFromMsg(header.stamp), header.frame_id);
}

}  // namespace detail

#define TF2_EIGEN_TRANSFORM(T) \
  template<> \
  inline void doTransform( \
    const Stamped<T> & in, Stamped<T> & out, \
    const geometry_msgs::msg::TransformStamped & transform) \
  { \
    detail::do_stamped(in, out, transform); \
  }

TF2_EIGEN_TRANSFORM(Eigen::Vector3d)
TF2_EIGEN_TRANSFORM(Eigen::Quaterniond)
TF2_EIGEN_TRANSFORM(Eigen::Affine3d)
TF2_EIGEN_TRANSFORM(Eigen::Isometry3d)

#undef TF2_EIGEN_TRANSFORM

}  // namespace tf2

// tf2::convert() is defined before these types, so it finds functions only in their namespace.
namespace Eigen
{

using tf2::fromMsg;
using tf2::toMsg;

}  // namespace Eigen
