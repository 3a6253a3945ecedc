#pragma once

#include "tf2/LinearMath/Matrix3x3.hpp"
#include "tf2/LinearMath/Quaternion.hpp"
#include "tf2/LinearMath/Vector3.hpp"

namespace tf2
{

/// A rotation followed by a translation.
class Transform
{
public:
  Transform() = default;
  explicit Transform(const Quaternion & q, const Vector3 & origin = Vector3(0, 0, 0))
  : basis_(q), origin_(origin) {}
  explicit Transform(const Matrix3x3 & basis, const Vector3 & origin = Vector3(0, 0, 0))
  : basis_(basis), origin_(origin) {}

  Vector3 operator()(const Vector3 & v) const {return basis_ * v + origin_;}
  Vector3 operator*(const Vector3 & v) const {return (*this)(v);}
  Quaternion operator*(const Quaternion & q) const {return getRotation() * q;}
  Transform operator*(const Transform & t) const
  {
    return Transform(basis_ * t.basis_, (*this)(t.origin_));
  }
  Transform & operator*=(const Transform & t) {return *this = *this * t;}
  void mult(const Transform & a, const Transform & b) {*this = a * b;}
  bool operator==(const Transform & t) const
  {
    return basis_ == t.basis_ && origin_ == t.origin_;
  }

  Matrix3x3 & getBasis() {return basis_;}
  const Matrix3x3 & getBasis() const {return basis_;}
  Vector3 & getOrigin() {return origin_;}
  const Vector3 & getOrigin() const {return origin_;}
  Quaternion getRotation() const
  {
    Quaternion q;
    basis_.getRotation(q);
    return q;
  }
  void setOrigin(const Vector3 & origin) {origin_ = origin;}
  void setBasis(const Matrix3x3 & basis) {basis_ = basis;}
  void setRotation(const Quaternion & q) {basis_.setRotation(q);}
  void setIdentity() {*this = getIdentity();}
  static const Transform & getIdentity()
  {
    static const Transform identity(Matrix3x3::getIdentity());
    return identity;
  }

  Transform inverse() const
  {
    const Matrix3x3 turned = basis_.transpose();
    return Transform(turned, turned * -origin_);
  }
  Transform inverseTimes(const Transform & t) const {return inverse() * t;}
  Vector3 invXform(const Vector3 & v) const {return basis_.transpose() * (v - origin_);}

  /// A 4x4 matrix in column-major order.
  void setFromOpenGLMatrix(const tf2Scalar * m)
  {
    basis_.setValue(m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10]);
    origin_.setValue(m[12], m[13], m[14]);
  }
  void getOpenGLMatrix(tf2Scalar * m) const
  {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {m[4 * i + j] = basis_[j][i];}
      m[4 * i + 3] = 0;
      m[12 + i] = origin_[i];
    }
    m[15] = 1;
  }

private:
  Matrix3x3 basis_;
  Vector3 origin_;
};

}  // namespace tf2
