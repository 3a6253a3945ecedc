// Conversions between messages and classes of libraries, which other packages define
// (tf2_geometry_msgs).
#pragma once

#include <array>
#include <string>
#include <type_traits>

#include "builtin_interfaces/msg/time.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rosidl_runtime_cpp/traits.hpp"
#include "tf2/exceptions.hpp"
#include "tf2/time.hpp"
#include "tf2/transform_datatypes.hpp"
#include "tf2/visibility_control.h"

namespace tf2
{

/// Specialized for each type that can be transformed.
template<class T>
void doTransform(
  const T & data_in, T & data_out, const geometry_msgs::msg::TransformStamped & transform);

template<typename A, typename B>
B toMsg(const A & a);
template<typename A, typename B>
B & toMsg(const A & a, B & b);
template<typename A, typename B>
void fromMsg(const A & a, B & b);

inline TimePoint TimePointFromMsg(const builtin_interfaces::msg::Time & time)
{
  return TimePoint(std::chrono::seconds(time.sec) + std::chrono::nanoseconds(time.nanosec));
}

namespace detail
{

template<class T, class = void>
struct has_header : std::false_type {};
template<class T>
struct has_header<T, std::void_t<decltype(std::declval<const T &>().header.frame_id)>>
  : std::true_type {};

}  // namespace detail

/// For messages with a header and for Stamped; specialized for other types.
template<class T>
TimePoint getTimestamp(const T & t)
{
  if constexpr (detail::has_header<T>::value) {
    return TimePointFromMsg(t.header.stamp);
  } else {
    return t.stamp_;
  }
}

template<class T>
std::string getFrameId(const T & t)
{
  if constexpr (detail::has_header<T>::value) {
    return t.header.frame_id;
  } else {
    return t.frame_id_;
  }
}

inline std::array<std::array<double, 6>, 6> covarianceRowMajorToNested(
  const std::array<double, 36> & rows)
{
  std::array<std::array<double, 6>, 6> nested;
  for (std::size_t i = 0; i < 36; ++i) {nested[i / 6][i % 6] = rows[i];}
  return nested;
}

inline std::array<double, 36> covarianceNestedToRowMajor(
  const std::array<std::array<double, 6>, 6> & nested)
{
  std::array<double, 36> rows;
  for (std::size_t i = 0; i < 36; ++i) {rows[i] = nested[i / 6][i % 6];}
  return rows;
}

/// For messages with a pose and its covariance, and for WithCovarianceStamped.
template<class T>
std::array<std::array<double, 6>, 6> getCovarianceMatrix(const T & t)
{
  if constexpr (detail::has_header<T>::value) {
    return covarianceRowMajorToNested(t.pose.covariance);
  } else {
    return t.cov_mat_;
  }
}

namespace impl
{

/// The conversion for each case of which type is a message.
template<bool IS_MESSAGE_A, bool IS_MESSAGE_B>
class Converter
{
public:
  template<typename A, typename B>
  static void convert(const A & a, B & b)
  {
    if constexpr (IS_MESSAGE_A) {
      fromMsg(a, b);
    } else if constexpr (IS_MESSAGE_B) {
      b = toMsg(a);
    } else {
      fromMsg(toMsg(a), b);
    }
  }
};

}  // namespace impl

/// Convert between any two types that have conversions to and from the same message.
template<class A, class B>
void convert(const A & a, B & b)
{
  if constexpr (std::is_same_v<A, B>) {
    if (&a != &b) {b = a;}
  } else {
    impl::Converter<
      rosidl_generator_traits::is_message<A>::value,
      rosidl_generator_traits::is_message<B>::value>::convert(a, b);
  }
}

}  // namespace tf2
