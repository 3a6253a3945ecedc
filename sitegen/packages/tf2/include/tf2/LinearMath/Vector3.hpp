#pragma once

#include "tf2/LinearMath/MinMax.hpp"
#include "tf2/LinearMath/Scalar.hpp"

namespace tf2
{

/// Three coordinates; a fourth number gives it the size of upstream's class.
class Vector3
{
public:
  tf2Scalar m_floats[4] = {0, 0, 0, 0};

  Vector3() = default;
  Vector3(const tf2Scalar & x, const tf2Scalar & y, const tf2Scalar & z)
  : m_floats{x, y, z, 0} {}

  const tf2Scalar & getX() const {return m_floats[0];}
  const tf2Scalar & getY() const {return m_floats[1];}
  const tf2Scalar & getZ() const {return m_floats[2];}
  void setX(tf2Scalar x) {m_floats[0] = x;}
  void setY(tf2Scalar y) {m_floats[1] = y;}
  void setZ(tf2Scalar z) {m_floats[2] = z;}
  void setW(tf2Scalar w) {m_floats[3] = w;}
  const tf2Scalar & x() const {return m_floats[0];}
  const tf2Scalar & y() const {return m_floats[1];}
  const tf2Scalar & z() const {return m_floats[2];}
  const tf2Scalar & w() const {return m_floats[3];}

  operator tf2Scalar * () {return m_floats;}  // NOLINT: implicit upstream
  operator const tf2Scalar * () const {return m_floats;}  // NOLINT: implicit upstream

  Vector3 & operator+=(const Vector3 & v) {return set(x() + v.x(), y() + v.y(), z() + v.z());}
  Vector3 & operator-=(const Vector3 & v) {return set(x() - v.x(), y() - v.y(), z() - v.z());}
  Vector3 & operator*=(const Vector3 & v) {return set(x() * v.x(), y() * v.y(), z() * v.z());}
  Vector3 & operator*=(const tf2Scalar & s) {return set(x() * s, y() * s, z() * s);}
  Vector3 & operator/=(const tf2Scalar & s) {return *this *= 1 / s;}
  bool operator==(const Vector3 & v) const {return std::equal(m_floats, m_floats + 4, v.m_floats);}
  bool operator!=(const Vector3 & v) const {return !(*this == v);}

  tf2Scalar dot(const Vector3 & v) const {return x() * v.x() + y() * v.y() + z() * v.z();}
  Vector3 cross(const Vector3 & v) const
  {
    return Vector3(
      y() * v.z() - z() * v.y(), z() * v.x() - x() * v.z(), x() * v.y() - y() * v.x());
  }
  tf2Scalar triple(const Vector3 & a, const Vector3 & b) const {return dot(a.cross(b));}
  tf2Scalar length2() const {return dot(*this);}
  tf2Scalar length() const {return tf2Sqrt(length2());}
  tf2Scalar distance2(const Vector3 & v) const;
  tf2Scalar distance(const Vector3 & v) const {return tf2Sqrt(distance2(v));}
  Vector3 & normalize() {return *this /= length();}
  Vector3 normalized() const {return Vector3(*this).normalize();}
  /// In radians.
  tf2Scalar angle(const Vector3 & v) const
  {
    return tf2Acos(dot(v) / tf2Sqrt(length2() * v.length2()));
  }
  /// Rotated by `angle` radians about `axis`, which has length 1.
  Vector3 rotate(const Vector3 & axis, const tf2Scalar & angle) const;
  Vector3 absolute() const {return Vector3(tf2Fabs(x()), tf2Fabs(y()), tf2Fabs(z()));}

  /// These return 0, 1 or 2, for x, y and z.
  int minAxis() const {return x() < y() ? (x() < z() ? 0 : 2) : (y() < z() ? 1 : 2);}
  int maxAxis() const {return x() < y() ? (y() < z() ? 2 : 1) : (x() < z() ? 2 : 0);}
  int furthestAxis() const {return absolute().minAxis();}
  int closestAxis() const {return absolute().maxAxis();}

  void setInterpolate3(const Vector3 & from, const Vector3 & to, tf2Scalar ratio)
  {
    *this = from.lerp(to, ratio);
  }
  Vector3 lerp(const Vector3 & v, const tf2Scalar & ratio) const
  {
    return Vector3(
      x() + (v.x() - x()) * ratio, y() + (v.y() - y()) * ratio, z() + (v.z() - z()) * ratio);
  }
  void setMax(const Vector3 & v)
  {
    for (int i = 0; i < 4; ++i) {tf2SetMax(m_floats[i], v.m_floats[i]);}
  }
  void setMin(const Vector3 & v)
  {
    for (int i = 0; i < 4; ++i) {tf2SetMin(m_floats[i], v.m_floats[i]);}
  }
  void setValue(const tf2Scalar & x, const tf2Scalar & y, const tf2Scalar & z) {set(x, y, z);}
  void setZero() {set(0, 0, 0);}
  bool isZero() const {return x() == 0 && y() == 0 && z() == 0;}
  bool fuzzyZero() const {return length2() < TF2SIMD_EPSILON;}

private:
  Vector3 & set(tf2Scalar x, tf2Scalar y, tf2Scalar z) {return *this = Vector3(x, y, z);}
};

inline Vector3 operator+(const Vector3 & a, const Vector3 & b) {return Vector3(a) += b;}
inline Vector3 operator-(const Vector3 & a, const Vector3 & b) {return Vector3(a) -= b;}
inline Vector3 operator-(const Vector3 & v) {return Vector3(-v.x(), -v.y(), -v.z());}
inline Vector3 operator*(const Vector3 & a, const Vector3 & b) {return Vector3(a) *= b;}
inline Vector3 operator*(const Vector3 & v, const tf2Scalar & s) {return Vector3(v) *= s;}
inline Vector3 operator*(const tf2Scalar & s, const Vector3 & v) {return v * s;}
inline Vector3 operator/(const Vector3 & v, const tf2Scalar & s) {return Vector3(v) /= s;}
inline Vector3 operator/(const Vector3 & a, const Vector3 & b)
{
  return Vector3(a.x() / b.x(), a.y() / b.y(), a.z() / b.z());
}

inline tf2Scalar tf2Dot(const Vector3 & a, const Vector3 & b) {return a.dot(b);}
inline tf2Scalar tf2Distance2(const Vector3 & a, const Vector3 & b) {return a.distance2(b);}
inline tf2Scalar tf2Distance(const Vector3 & a, const Vector3 & b) {return a.distance(b);}
inline tf2Scalar tf2Angle(const Vector3 & a, const Vector3 & b) {return a.angle(b);}
inline Vector3 tf2Cross(const Vector3 & a, const Vector3 & b) {return a.cross(b);}
inline tf2Scalar tf2Triple(const Vector3 & a, const Vector3 & b, const Vector3 & c)
{
  return a.triple(b, c);
}
inline Vector3 lerp(const Vector3 & a, const Vector3 & b, const tf2Scalar & ratio)
{
  return a.lerp(b, ratio);
}

inline tf2Scalar Vector3::distance2(const Vector3 & v) const {return (v - *this).length2();}

inline Vector3 Vector3::rotate(const Vector3 & axis, const tf2Scalar & angle) const
{
  const Vector3 along = axis * axis.dot(*this);
  return along + (*this - along) * tf2Cos(angle) + axis.cross(*this) * tf2Sin(angle);
}

}  // namespace tf2
