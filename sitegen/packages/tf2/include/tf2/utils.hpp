// Euler angles of any type with a rotation, in radians.
#pragma once

#include "geometry_msgs/msg/quaternion.hpp"
#include "geometry_msgs/msg/quaternion_stamped.hpp"
#include "geometry_msgs/msg/transform.hpp"
#include "tf2/LinearMath/Matrix3x3.hpp"
#include "tf2/LinearMath/Quaternion.hpp"
#include "tf2/LinearMath/Transform.hpp"
#include "tf2/convert.hpp"
#include "tf2/transform_datatypes.hpp"

namespace tf2
{
namespace impl
{

inline Quaternion toQuaternion(const Quaternion & q) {return q;}
inline Quaternion toQuaternion(const Transform & t) {return t.getRotation();}
inline Quaternion toQuaternion(const geometry_msgs::msg::Quaternion & q)
{
  return Quaternion(q.x, q.y, q.z, q.w);
}
inline Quaternion toQuaternion(const geometry_msgs::msg::QuaternionStamped & q)
{
  return toQuaternion(q.quaternion);
}
template<typename T>
Quaternion toQuaternion(const Stamped<T> & t) {return toQuaternion(static_cast<const T &>(t));}
template<typename T>
Quaternion toQuaternion(const T & t)
{
  geometry_msgs::msg::Quaternion q = toMsg(t);
  return toQuaternion(q);
}

}  // namespace impl

/// About z, y and x.
template<class A>
void getEulerYPR(const A & a, double & yaw, double & pitch, double & roll)
{
  Matrix3x3(impl::toQuaternion(a)).getEulerYPR(yaw, pitch, roll);
}

template<class A>
double getYaw(const A & a)
{
  double yaw, pitch, roll;
  getEulerYPR(a, yaw, pitch, roll);
  return yaw;
}

template<class A>
A getTransformIdentity()
{
  A t;
  t.setIdentity();
  return t;
}

}  // namespace tf2
