#pragma once

#include <string>

#include "builtin_interfaces/msg/duration.hpp"
#include "builtin_interfaces/msg/time.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/duration.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp/time.hpp"
#include "tf2/buffer_core.hpp"
#include "tf2/convert.hpp"
#include "tf2/exceptions.hpp"
#include "tf2/time.hpp"
#include "tf2/transform_datatypes.hpp"
#include "tf2_ros/visibility_control.h"

namespace tf2_ros
{

inline builtin_interfaces::msg::Time toMsg(const tf2::TimePoint & time)
{
  return rclcpp::Time(time.time_since_epoch().count());
}
inline tf2::TimePoint fromMsg(const builtin_interfaces::msg::Time & time)
{
  return tf2::TimePointFromMsg(time);
}
inline builtin_interfaces::msg::Duration toMsg(const tf2::Duration & duration)
{
  return rclcpp::Duration(duration);
}
inline tf2::Duration fromMsg(const builtin_interfaces::msg::Duration & duration)
{
  return tf2::Duration(rclcpp::Duration(duration).nanoseconds());
}
inline double timeToSec(const builtin_interfaces::msg::Time & time)
{
  return tf2::timeToSec(fromMsg(time));
}
inline rclcpp::Time toRclcpp(const tf2::TimePoint & time)
{
  return rclcpp::Time(time.time_since_epoch().count());
}
inline tf2::TimePoint fromRclcpp(const rclcpp::Time & time)
{
  return tf2::TimePoint(tf2::Duration(time.nanoseconds()));
}
inline rclcpp::Duration toRclcpp(const tf2::Duration & duration)
{
  return rclcpp::Duration(duration);
}
inline tf2::Duration fromRclcpp(const rclcpp::Duration & duration)
{
  return tf2::Duration(duration.nanoseconds());
}

/// Looks up transforms, and waits for them up to `timeout`.
class BufferInterface
{
public:
  virtual ~BufferInterface() = default;

  virtual geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target_frame, const std::string & source_frame,
    const tf2::TimePoint & time, const tf2::Duration timeout) const = 0;
  virtual geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target_frame, const tf2::TimePoint & target_time,
    const std::string & source_frame, const tf2::TimePoint & source_time,
    const std::string & fixed_frame, const tf2::Duration timeout) const = 0;
  virtual bool canTransform(
    const std::string & target_frame, const std::string & source_frame,
    const tf2::TimePoint & time, const tf2::Duration timeout, std::string * error) const = 0;
  virtual bool canTransform(
    const std::string & target_frame, const tf2::TimePoint & target_time,
    const std::string & source_frame, const tf2::TimePoint & source_time,
    const std::string & fixed_frame, const tf2::Duration timeout, std::string * error) const = 0;

  /// Transform `in`, which has a frame and a time, to `target_frame`.
  template<class T>
  T & transform(
    const T & in, T & out, const std::string & target_frame,
    tf2::Duration timeout = tf2::Duration::zero()) const
  {
    tf2::doTransform(
      in, out, lookupTransform(
        target_frame, tf2::getFrameId(in), tf2::getTimestamp(in), timeout));
    return out;
  }
  template<class T>
  T transform(
    const T & in, const std::string & target_frame,
    tf2::Duration timeout = tf2::Duration::zero()) const
  {
    T out;
    return transform(in, out, target_frame, timeout);
  }
  /// Transform and convert to another type.
  template<class A, class B>
  B & transform(
    const A & in, B & out, const std::string & target_frame,
    tf2::Duration timeout = tf2::Duration::zero()) const
  {
    tf2::convert(transform(in, target_frame, timeout), out);
    return out;
  }
  template<class T>
  T & transform(
    const T & in, T & out, const std::string & target_frame, const tf2::TimePoint & target_time,
    const std::string & fixed_frame, tf2::Duration timeout = tf2::Duration::zero()) const
  {
    tf2::doTransform(
      in, out, lookupTransform(
        target_frame, target_time, tf2::getFrameId(in), tf2::getTimestamp(in), fixed_frame,
        timeout));
    return out;
  }
  template<class T>
  T transform(
    const T & in, const std::string & target_frame, const tf2::TimePoint & target_time,
    const std::string & fixed_frame, tf2::Duration timeout = tf2::Duration::zero()) const
  {
    T out;
    return transform(in, out, target_frame, target_time, fixed_frame, timeout);
  }
};

}  // namespace tf2_ros
