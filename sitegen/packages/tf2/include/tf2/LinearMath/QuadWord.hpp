#pragma once

#include "tf2/LinearMath/MinMax.hpp"
#include "tf2/LinearMath/Scalar.hpp"

namespace tf2
{

/// Four numbers: the common base of vectors and quaternions.
class QuadWord
{
public:
  QuadWord() = default;
  QuadWord(const tf2Scalar & x, const tf2Scalar & y, const tf2Scalar & z, const tf2Scalar & w = 0)
  : m_floats{x, y, z, w} {}

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

  bool operator==(const QuadWord & other) const {return std::equal(m_floats, m_floats + 4, other.m_floats);}
  bool operator!=(const QuadWord & other) const {return !(*this == other);}

  void setValue(const tf2Scalar & x, const tf2Scalar & y, const tf2Scalar & z)
  {
    setValue(x, y, z, 0);
  }
  void setValue(
    const tf2Scalar & x, const tf2Scalar & y, const tf2Scalar & z, const tf2Scalar & w)
  {
    m_floats[0] = x;
    m_floats[1] = y;
    m_floats[2] = z;
    m_floats[3] = w;
  }
  void setMax(const QuadWord & other)
  {
    for (int i = 0; i < 4; ++i) {tf2SetMax(m_floats[i], other.m_floats[i]);}
  }
  void setMin(const QuadWord & other)
  {
    for (int i = 0; i < 4; ++i) {tf2SetMin(m_floats[i], other.m_floats[i]);}
  }

protected:
  tf2Scalar m_floats[4] = {0, 0, 0, 0};
};

}  // namespace tf2
