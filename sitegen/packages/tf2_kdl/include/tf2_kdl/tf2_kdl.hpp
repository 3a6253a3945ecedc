// Conversions between messages of geometry_msgs and types of KDL.
#pragma once

#include "builtin_interfaces/msg/time.hpp"
#include "geometry_msgs/msg/point_stamped.hpp"
#include "geometry_msgs/msg/pose.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "geometry_msgs/msg/wrench_stamped.hpp"
#include "kdl/frames.hpp"
#include "tf2/convert.hpp"
#include "tf2_ros/buffer_interface.hpp"

namespace tf2
{

namespace kdl
{

template<typename Message>
void to_xyz(const KDL::Vector & in, Message & out)
{
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
}

template<typename Message>
KDL::Vector vector_of(const Message & in)
{
  return {in.x, in.y, in.z};
}

template<typename Message>
KDL::Rotation rotation_of(const Message & in)
{
  return KDL::Rotation::Quaternion(in.x, in.y, in.z, in.w);
}

// Return an empty stamped message with the stamp and the frame of `in`.
template<typename Message, typename T>
Message stamped(const Stamped<T> & in)
{
  Message out;
  out.header.stamp = tf2_ros::toMsg(in.stamp_);
  out.header.frame_id = in.frame_id_;
  return out;
}

template<typename T>
void set_stamp(const std_msgs::msg::Header & header, Stamped<T> & out)
{
  out.stamp_ = tf2_ros::fromMsg(header.stamp);
  out.frame_id_ = header.frame_id;
}

}  // namespace kdl

inline KDL::Frame transformToKDL(const geometry_msgs::msg::TransformStamped & t)
{
  const auto & transform = t.transform;
  return {kdl::rotation_of(transform.rotation), kdl::vector_of(transform.translation)};
}
inline geometry_msgs::msg::TransformStamped kdlToTransform(const KDL::Frame & k)
{
  geometry_msgs::msg::TransformStamped out;
  auto & rotation = out.transform.rotation;
  kdl::to_xyz(k.p, out.transform.translation);
  k.M.GetQuaternion(rotation.x, rotation.y, rotation.z, rotation.w);
  return out;
}

#define TF2_KDL_TRANSFORM(T) \
  template<> \
  inline void doTransform( \
    const Stamped<T> & in, Stamped<T> & out, \
    const geometry_msgs::msg::TransformStamped & transform) \
  { \
    const auto & header = transform.header; \
    out = Stamped<T>( \
      transformToKDL(transform) * in, tf2_ros::fromMsg(header.stamp), header.frame_id); \
  }

TF2_KDL_TRANSFORM(KDL::Vector)
TF2_KDL_TRANSFORM(KDL::Twist)
TF2_KDL_TRANSFORM(KDL::Wrench)
TF2_KDL_TRANSFORM(KDL::Frame)
#undef TF2_KDL_TRANSFORM

inline geometry_msgs::msg::PointStamped toMsg(const Stamped<KDL::Vector> & in)
{
  auto out = kdl::stamped<geometry_msgs::msg::PointStamped>(in);
  kdl::to_xyz(in, out.point);
  return out;
}
inline void fromMsg(const geometry_msgs::msg::PointStamped & in, Stamped<KDL::Vector> & out)
{
  kdl::set_stamp(in.header, out);
  static_cast<KDL::Vector &>(out) = kdl::vector_of(in.point);
}

inline geometry_msgs::msg::TwistStamped toMsg(const Stamped<KDL::Twist> & in)
{
  auto out = kdl::stamped<geometry_msgs::msg::TwistStamped>(in);
  kdl::to_xyz(in.vel, out.twist.linear);
  kdl::to_xyz(in.rot, out.twist.angular);
  return out;
}
inline void fromMsg(const geometry_msgs::msg::TwistStamped & in, Stamped<KDL::Twist> & out)
{
  kdl::set_stamp(in.header, out);
  out.vel = kdl::vector_of(in.twist.linear);
  out.rot = kdl::vector_of(in.twist.angular);
}

inline geometry_msgs::msg::WrenchStamped toMsg(const Stamped<KDL::Wrench> & in)
{
  auto out = kdl::stamped<geometry_msgs::msg::WrenchStamped>(in);
  kdl::to_xyz(in.force, out.wrench.force);
  kdl::to_xyz(in.torque, out.wrench.torque);
  return out;
}
inline void fromMsg(const geometry_msgs::msg::WrenchStamped & in, Stamped<KDL::Wrench> & out)
{
  kdl::set_stamp(in.header, out);
  out.force = kdl::vector_of(in.wrench.force);
  out.torque = kdl::vector_of(in.wrench.torque);
}

inline geometry_msgs::msg::Pose toMsg(const KDL::Frame & in)
{
  geometry_msgs::msg::Pose out;
  auto & rotation = out.orientation;
  kdl::to_xyz(in.p, out.position);
  in.M.GetQuaternion(rotation.x, rotation.y, rotation.z, rotation.w);
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Pose & in, KDL::Frame & out)
{
  out = {kdl::rotation_of(in.orientation), kdl::vector_of(in.position)};
}
inline geometry_msgs::msg::PoseStamped toMsg(const Stamped<KDL::Frame> & in)
{
  auto out = kdl::stamped<geometry_msgs::msg::PoseStamped>(in);
  out.pose = toMsg(static_cast<const KDL::Frame &>(in));
  return out;
}
inline void fromMsg(const geometry_msgs::msg::PoseStamped & in, Stamped<KDL::Frame> & out)
{
  kdl::set_stamp(in.header, out);
  fromMsg(in.pose, static_cast<KDL::Frame &>(out));
}

}  // namespace tf2
