#pragma once

#include "tf2/LinearMath/Quaternion.hpp"
#include "tf2/LinearMath/Vector3.hpp"

namespace tf2
{

/// A 3x3 matrix, usually a rotation. Angles are in radians.
class Matrix3x3
{
public:
  Matrix3x3() = default;
  explicit Matrix3x3(const Quaternion & q) {setRotation(q);}
  Matrix3x3(
    const tf2Scalar & xx, const tf2Scalar & xy, const tf2Scalar & xz,
    const tf2Scalar & yx, const tf2Scalar & yy, const tf2Scalar & yz,
    const tf2Scalar & zx, const tf2Scalar & zy, const tf2Scalar & zz)
  : rows_{Vector3(xx, xy, xz), Vector3(yx, yy, yz), Vector3(zx, zy, zz)} {}

  Vector3 getColumn(int i) const {return Vector3(rows_[0][i], rows_[1][i], rows_[2][i]);}
  const Vector3 & getRow(int i) const {return rows_[i];}
  Vector3 & operator[](int i) {return rows_[i];}
  const Vector3 & operator[](int i) const {return rows_[i];}
  Matrix3x3 & operator*=(const Matrix3x3 & m);
  bool operator==(const Matrix3x3 & m) const {return std::equal(rows_, rows_ + 3, m.rows_);}

  void setValue(
    const tf2Scalar & xx, const tf2Scalar & xy, const tf2Scalar & xz,
    const tf2Scalar & yx, const tf2Scalar & yy, const tf2Scalar & yz,
    const tf2Scalar & zx, const tf2Scalar & zy, const tf2Scalar & zz)
  {
    *this = Matrix3x3(xx, xy, xz, yx, yy, yz, zx, zy, zz);
  }
  void setRotation(const Quaternion & q);
  void setEulerZYX(tf2Scalar x, tf2Scalar y, tf2Scalar z) {setRPY(x, y, z);}
  void setEulerYPR(const tf2Scalar & yaw, const tf2Scalar & pitch, const tf2Scalar & roll)
  {
    setRPY(roll, pitch, yaw);
  }
  void setRPY(tf2Scalar roll, tf2Scalar pitch, tf2Scalar yaw)
  {
    Quaternion q;
    q.setRPY(roll, pitch, yaw);
    setRotation(q);
  }
  void setIdentity() {*this = getIdentity();}
  static const Matrix3x3 & getIdentity()
  {
    static const Matrix3x3 identity(1, 0, 0, 0, 1, 0, 0, 0, 1);
    return identity;
  }

  void getRotation(Quaternion & q) const;
  /// The first of the two solutions has a pitch between -π/2 and π/2. At these limits, yaw and roll
  /// have the same axis, and the yaw is set to 0.
  void getEulerYPR(
    tf2Scalar & yaw, tf2Scalar & pitch, tf2Scalar & roll, unsigned int solution_number = 1) const;
  void getEulerZYX(
    tf2Scalar & yaw, tf2Scalar & pitch, tf2Scalar & roll, unsigned int solution_number = 1) const
  {
    getEulerYPR(yaw, pitch, roll, solution_number);
  }
  void getRPY(
    tf2Scalar & roll, tf2Scalar & pitch, tf2Scalar & yaw, unsigned int solution_number = 1) const
  {
    getEulerYPR(yaw, pitch, roll, solution_number);
  }

  Matrix3x3 scaled(const Vector3 & s) const
  {
    return of_rows(rows_[0] * s, rows_[1] * s, rows_[2] * s);
  }
  tf2Scalar determinant() const {return rows_[0].triple(rows_[1], rows_[2]);}
  Matrix3x3 adjoint() const
  {
    return of_rows(
      rows_[1].cross(rows_[2]), rows_[2].cross(rows_[0]), rows_[0].cross(rows_[1])).transpose();
  }
  Matrix3x3 absolute() const
  {
    return of_rows(rows_[0].absolute(), rows_[1].absolute(), rows_[2].absolute());
  }
  Matrix3x3 transpose() const {return of_rows(getColumn(0), getColumn(1), getColumn(2));}
  Matrix3x3 inverse() const
  {
    const Matrix3x3 a = adjoint();
    const tf2Scalar s = 1 / determinant();
    return of_rows(a[0] * s, a[1] * s, a[2] * s);
  }
  /// The cofactor of the two rows and columns.
  tf2Scalar cofac(int r1, int c1, int r2, int c2) const
  {
    return rows_[r1][c1] * rows_[r2][c2] - rows_[r1][c2] * rows_[r2][c1];
  }
  /// From and to the columns of a 4x4 matrix of OpenGL.
  void setFromOpenGLSubMatrix(const tf2Scalar * m)
  {
    setValue(m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10]);
  }
  void getOpenGLSubMatrix(tf2Scalar * m) const
  {
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row) {m[4 * column + row] = rows_[row][column];}
      m[4 * column + 3] = 0;
    }
  }
  Matrix3x3 transposeTimes(const Matrix3x3 & m) const;
  Matrix3x3 timesTranspose(const Matrix3x3 & m) const;
  tf2Scalar tdotx(const Vector3 & v) const {return getColumn(0).dot(v);}
  tf2Scalar tdoty(const Vector3 & v) const {return getColumn(1).dot(v);}
  tf2Scalar tdotz(const Vector3 & v) const {return getColumn(2).dot(v);}

private:
  static Matrix3x3 of_rows(const Vector3 & x, const Vector3 & y, const Vector3 & z)
  {
    Matrix3x3 m;
    m[0] = x;
    m[1] = y;
    m[2] = z;
    return m;
  }

  Vector3 rows_[3];
};

inline Vector3 operator*(const Matrix3x3 & m, const Vector3 & v)
{
  return Vector3(m[0].dot(v), m[1].dot(v), m[2].dot(v));
}
inline Vector3 operator*(const Vector3 & v, const Matrix3x3 & m) {return m.transpose() * v;}
inline Matrix3x3 operator*(const Matrix3x3 & a, const Matrix3x3 & b)
{
  Matrix3x3 m;
  for (int i = 0; i < 3; ++i) {m[i] = a[i] * b;}
  return m;
}
inline Matrix3x3 & Matrix3x3::operator*=(const Matrix3x3 & m) {return *this = *this * m;}
inline Matrix3x3 Matrix3x3::transposeTimes(const Matrix3x3 & m) const {return transpose() * m;}
inline Matrix3x3 Matrix3x3::timesTranspose(const Matrix3x3 & m) const
{
  return *this * m.transpose();
}

inline void Matrix3x3::setRotation(const Quaternion & q)
{
  const tf2Scalar s = 2 / q.length2();
  const tf2Scalar xs = q.x() * s, ys = q.y() * s, zs = q.z() * s;
  const tf2Scalar wx = q.w() * xs, wy = q.w() * ys, wz = q.w() * zs;
  const tf2Scalar xx = q.x() * xs, xy = q.x() * ys, xz = q.x() * zs;
  const tf2Scalar yy = q.y() * ys, yz = q.y() * zs, zz = q.z() * zs;
  setValue(
    1 - (yy + zz), xy - wz, xz + wy,
    xy + wz, 1 - (xx + zz), yz - wx,
    xz - wy, yz + wx, 1 - (xx + yy));
}

inline void Matrix3x3::getRotation(Quaternion & q) const
{
  const tf2Scalar trace = rows_[0].x() + rows_[1].y() + rows_[2].z();
  if (trace > 0) {
    const tf2Scalar s = tf2Sqrt(trace + 1);
    const tf2Scalar f = 0.5 / s;
    q.setValue(
      (rows_[2].y() - rows_[1].z()) * f, (rows_[0].z() - rows_[2].x()) * f,
      (rows_[1].x() - rows_[0].y()) * f, s / 2);
    return;
  }
  // Start from the largest diagonal element, to avoid division by a small number.
  const int i = Vector3(rows_[0].x(), rows_[1].y(), rows_[2].z()).maxAxis();
  const int j = (i + 1) % 3, k = (i + 2) % 3;
  const tf2Scalar s = tf2Sqrt(rows_[i][i] - rows_[j][j] - rows_[k][k] + 1);
  tf2Scalar v[3];
  v[i] = s / 2;
  v[j] = (rows_[j][i] + rows_[i][j]) * 0.5 / s;
  v[k] = (rows_[k][i] + rows_[i][k]) * 0.5 / s;
  q.setValue(v[0], v[1], v[2], (rows_[k][j] - rows_[j][k]) * 0.5 / s);
}

inline void Matrix3x3::getEulerYPR(
  tf2Scalar & yaw, tf2Scalar & pitch, tf2Scalar & roll, unsigned int solution_number) const
{
  if (tf2Fabs(rows_[2].x()) >= 1) {
    const bool down = rows_[2].x() < 0;
    yaw = 0;
    pitch = down ? TF2SIMD_HALF_PI : -TF2SIMD_HALF_PI;
    roll = down ? tf2Atan2(rows_[0].y(), rows_[0].z()) : tf2Atan2(-rows_[0].y(), -rows_[0].z());
    return;
  }
  pitch = -tf2Asin(rows_[2].x());
  if (solution_number != 1) {pitch = TF2SIMD_PI - pitch;}
  const tf2Scalar c = tf2Cos(pitch);
  roll = tf2Atan2(rows_[2].y() / c, rows_[2].z() / c);
  yaw = tf2Atan2(rows_[1].x() / c, rows_[0].x() / c);
}

}  // namespace tf2
