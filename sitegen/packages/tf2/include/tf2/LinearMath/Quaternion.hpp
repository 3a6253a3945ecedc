#pragma once

#include "tf2/LinearMath/QuadWord.hpp"
#include "tf2/LinearMath/Vector3.hpp"

namespace tf2
{

/// A rotation as x, y, z, w. Angles are in radians.
class Quaternion : public QuadWord
{
public:
  Quaternion() = default;
  Quaternion(
    const tf2Scalar & x, const tf2Scalar & y, const tf2Scalar & z, const tf2Scalar & w)
  : QuadWord(x, y, z, w) {}
  Quaternion(const Vector3 & axis, const tf2Scalar & angle) {setRotation(axis, angle);}

  void setRotation(const Vector3 & axis, const tf2Scalar & angle)
  {
    const Vector3 v = axis * (tf2Sin(angle / 2) / axis.length());
    setValue(v.x(), v.y(), v.z(), tf2Cos(angle / 2));
  }
  /// About y, then the new x, then the new z.
  void setEuler(const tf2Scalar & yaw, const tf2Scalar & pitch, const tf2Scalar & roll);
  /// About the fixed axes x, y, z, in this order.
  void setRPY(const tf2Scalar & roll, const tf2Scalar & pitch, const tf2Scalar & yaw);

  Quaternion & operator+=(const Quaternion & q)
  {
    return *this = Quaternion(x() + q.x(), y() + q.y(), z() + q.z(), w() + q.w());
  }
  Quaternion & operator-=(const Quaternion & q)
  {
    return *this = Quaternion(x() - q.x(), y() - q.y(), z() - q.z(), w() - q.w());
  }
  Quaternion & operator*=(const tf2Scalar & s)
  {
    return *this = Quaternion(x() * s, y() * s, z() * s, w() * s);
  }
  Quaternion & operator/=(const tf2Scalar & s) {return *this *= 1 / s;}
  Quaternion & operator*=(const Quaternion & q);
  Quaternion operator+(const Quaternion & q) const {return Quaternion(*this) += q;}
  Quaternion operator-(const Quaternion & q) const {return Quaternion(*this) -= q;}
  Quaternion operator-() const {return Quaternion(-x(), -y(), -z(), -w());}
  Quaternion operator*(const tf2Scalar & s) const {return Quaternion(*this) *= s;}
  Quaternion operator/(const tf2Scalar & s) const {return Quaternion(*this) /= s;}

  tf2Scalar dot(const Quaternion & q) const
  {
    return x() * q.x() + y() * q.y() + z() * q.z() + w() * q.w();
  }
  tf2Scalar length2() const {return dot(*this);}
  tf2Scalar length() const {return tf2Sqrt(length2());}
  Quaternion & normalize() {return *this /= length();}
  Quaternion normalized() const {return Quaternion(*this).normalize();}
  Quaternion inverse() const {return Quaternion(-x(), -y(), -z(), w());}

  /// Half of the angle between two rotations.
  tf2Scalar angle(const Quaternion & q) const
  {
    return tf2Acos(dot(q) / tf2Sqrt(length2() * q.length2()));
  }
  tf2Scalar angleShortestPath(const Quaternion & q) const
  {
    return tf2Acos(tf2Fabs(dot(q)) / tf2Sqrt(length2() * q.length2())) * 2;
  }
  tf2Scalar getAngle() const {return 2 * tf2Acos(w());}
  tf2Scalar getAngleShortestPath() const {return 2 * tf2Acos(tf2Fabs(w()));}
  Vector3 getAxis() const;

  Quaternion farthest(const Quaternion & q) const {return is_near(q) ? -q : q;}
  Quaternion nearest(const Quaternion & q) const {return is_near(q) ? q : -q;}
  /// The rotation between this at ratio 0 and `q` at 1, along the shorter arc.
  Quaternion slerp(const Quaternion & q, const tf2Scalar & ratio) const;

  static const Quaternion & getIdentity()
  {
    static const Quaternion identity(0, 0, 0, 1);
    return identity;
  }
  const tf2Scalar & getW() const {return w();}

private:
  bool is_near(const Quaternion & q) const
  {
    return (*this - q).length2() < (*this + q).length2();
  }
};

inline Quaternion operator*(const Quaternion & a, const Quaternion & b)
{
  return Quaternion(
    a.w() * b.x() + a.x() * b.w() + a.y() * b.z() - a.z() * b.y(),
    a.w() * b.y() + a.y() * b.w() + a.z() * b.x() - a.x() * b.z(),
    a.w() * b.z() + a.z() * b.w() + a.x() * b.y() - a.y() * b.x(),
    a.w() * b.w() - a.x() * b.x() - a.y() * b.y() - a.z() * b.z());
}
inline Quaternion operator*(const Quaternion & q, const Vector3 & v)
{
  return q * Quaternion(v.x(), v.y(), v.z(), 0);
}
inline Quaternion operator*(const Vector3 & v, const Quaternion & q)
{
  return Quaternion(v.x(), v.y(), v.z(), 0) * q;
}
inline Quaternion & Quaternion::operator*=(const Quaternion & q) {return *this = *this * q;}

inline tf2Scalar dot(const Quaternion & a, const Quaternion & b) {return a.dot(b);}
inline tf2Scalar length(const Quaternion & q) {return q.length();}
inline tf2Scalar angle(const Quaternion & a, const Quaternion & b) {return a.angle(b);}
inline tf2Scalar angleShortestPath(const Quaternion & a, const Quaternion & b)
{
  return a.angleShortestPath(b);
}
inline Quaternion inverse(const Quaternion & q) {return q.inverse();}
inline Quaternion slerp(const Quaternion & a, const Quaternion & b, const tf2Scalar & ratio)
{
  return a.slerp(b, ratio);
}
inline Vector3 quatRotate(const Quaternion & rotation, const Vector3 & v)
{
  const Quaternion q = rotation * v * rotation.inverse();
  return Vector3(q.x(), q.y(), q.z());
}
/// The rotation from `from` to `to`, both of length 1.
inline Quaternion shortestArcQuat(const Vector3 & from, const Vector3 & to)
{
  const tf2Scalar d = from.dot(to);
  if (d < -1 + TF2SIMD_EPSILON) {
    const Vector3 other = tf2Fabs(from.x()) < 0.9 ? Vector3(1, 0, 0) : Vector3(0, 1, 0);
    const Vector3 n = from.cross(other).normalized();  // any that is at a right angle
    return Quaternion(n.x(), n.y(), n.z(), 0);
  }
  const Vector3 c = from.cross(to);
  const tf2Scalar s = tf2Sqrt((1 + d) * 2);
  return Quaternion(c.x() / s, c.y() / s, c.z() / s, s / 2);
}
inline Quaternion shortestArcQuatNormalize2(Vector3 & from, Vector3 & to)
{
  return shortestArcQuat(from.normalize(), to.normalize());
}

inline void Quaternion::setEuler(
  const tf2Scalar & yaw, const tf2Scalar & pitch, const tf2Scalar & roll)
{
  *this = Quaternion(Vector3(0, 1, 0), yaw) * Quaternion(Vector3(1, 0, 0), pitch) *
    Quaternion(Vector3(0, 0, 1), roll);
}

inline void Quaternion::setRPY(
  const tf2Scalar & roll, const tf2Scalar & pitch, const tf2Scalar & yaw)
{
  *this = Quaternion(Vector3(0, 0, 1), yaw) * Quaternion(Vector3(0, 1, 0), pitch) *
    Quaternion(Vector3(1, 0, 0), roll);
}

inline Vector3 Quaternion::getAxis() const
{
  const tf2Scalar s2 = 1 - w() * w();
  if (s2 < 10 * TF2SIMD_EPSILON) {return Vector3(1, 0, 0);}
  return Vector3(x(), y(), z()) / tf2Sqrt(s2);
}

inline Quaternion Quaternion::slerp(const Quaternion & q, const tf2Scalar & ratio) const
{
  const tf2Scalar theta = angleShortestPath(q) / 2;
  if (theta == 0) {return *this;}
  const Quaternion end = dot(q) < 0 ? -q : q;
  return (*this * tf2Sin((1 - ratio) * theta) + end * tf2Sin(ratio * theta)) / tf2Sin(theta);
}

}  // namespace tf2
