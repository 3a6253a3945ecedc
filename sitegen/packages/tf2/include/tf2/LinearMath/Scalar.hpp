// The number type of transforms, and the functions on it.
#pragma once

#include <algorithm>
#include <cassert>
#include <cfloat>
#include <cmath>

typedef double tf2Scalar;

#define TF2SIMD_FORCE_INLINE inline
#define TF2SIMD_PI tf2Scalar(3.1415926535897932384626433832795029)
#define TF2SIMD_2_PI (tf2Scalar(2.0) * TF2SIMD_PI)
#define TF2SIMD_HALF_PI (TF2SIMD_PI * tf2Scalar(0.5))
#define TF2SIMD_RADS_PER_DEG (TF2SIMD_2_PI / tf2Scalar(360.0))
#define TF2SIMD_DEGS_PER_RAD (tf2Scalar(360.0) / TF2SIMD_2_PI)
#define tf2RecipSqrt(x) (tf2Scalar(1.0) / tf2Sqrt(tf2Scalar(x)))
#define tf2Assert(x) assert(x)
#define tf2FullAssert(x) assert(x)
#define tf2Likely(x) (x)
#define tf2Unlikely(x) (x)
#define TF2SIMDSQRT12 tf2Scalar(0.7071067811865475244008443621048490)
#define TF2SIMD_EPSILON DBL_EPSILON
#define TF2SIMD_INFINITY DBL_MAX

inline tf2Scalar tf2Sqrt(tf2Scalar x) {return std::sqrt(x);}
inline tf2Scalar tf2Fabs(tf2Scalar x) {return std::fabs(x);}
inline tf2Scalar tf2Cos(tf2Scalar x) {return std::cos(x);}
inline tf2Scalar tf2Sin(tf2Scalar x) {return std::sin(x);}
inline tf2Scalar tf2Tan(tf2Scalar x) {return std::tan(x);}
/// These two clamp arguments that rounding put outside of [-1, 1].
inline tf2Scalar tf2Acos(tf2Scalar x) {return std::acos(std::clamp(x, -1.0, 1.0));}
inline tf2Scalar tf2Asin(tf2Scalar x) {return std::asin(std::clamp(x, -1.0, 1.0));}
inline tf2Scalar tf2Atan(tf2Scalar x) {return std::atan(x);}
inline tf2Scalar tf2Atan2(tf2Scalar y, tf2Scalar x) {return std::atan2(y, x);}
inline tf2Scalar tf2Exp(tf2Scalar x) {return std::exp(x);}
inline tf2Scalar tf2Log(tf2Scalar x) {return std::log(x);}
inline tf2Scalar tf2Pow(tf2Scalar x, tf2Scalar y) {return std::pow(x, y);}
inline tf2Scalar tf2Fmod(tf2Scalar x, tf2Scalar y) {return std::fmod(x, y);}

inline bool tf2FuzzyZero(tf2Scalar x) {return tf2Fabs(x) < TF2SIMD_EPSILON;}
inline bool tf2Equal(tf2Scalar x, tf2Scalar limit) {return tf2Fabs(x) <= limit;}
inline bool tf2GreaterEqual(tf2Scalar x, tf2Scalar limit) {return !(x <= limit);}
inline int tf2IsNegative(tf2Scalar x) {return x < 0 ? 1 : 0;}
inline tf2Scalar tf2Radians(tf2Scalar degrees) {return degrees * TF2SIMD_RADS_PER_DEG;}
inline tf2Scalar tf2Degrees(tf2Scalar radians) {return radians * TF2SIMD_DEGS_PER_RAD;}
inline tf2Scalar tf2Fsel(tf2Scalar a, tf2Scalar b, tf2Scalar c) {return a >= 0 ? b : c;}
inline tf2Scalar tf2NormalizeAngle(tf2Scalar angle)
{
  angle = tf2Fmod(angle, TF2SIMD_2_PI);
  if (angle < -TF2SIMD_PI) {return angle + TF2SIMD_2_PI;}
  return angle > TF2SIMD_PI ? angle - TF2SIMD_2_PI : angle;
}

inline unsigned tf2Select(unsigned condition, unsigned if_set, unsigned if_zero)
{
  return condition ? if_set : if_zero;
}
inline int tf2Select(unsigned condition, int if_set, int if_zero)
{
  return condition ? if_set : if_zero;
}
inline float tf2Select(unsigned condition, float if_set, float if_zero)
{
  return condition ? if_set : if_zero;
}

template<typename T>
inline void tf2Swap(T & a, T & b) {std::swap(a, b);}
