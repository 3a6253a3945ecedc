#pragma once

#include <array>
#include <string>

#include "tf2/time.hpp"

namespace tf2
{

/// Data with a frame and a time.
template<typename T>
class Stamped : public T
{
public:
  TimePoint stamp_ = TimePointZero;
  std::string frame_id_ = "NO_ID_STAMPED_DEFAULT_CONSTRUCTION";

  Stamped() = default;
  Stamped(const T & data, const TimePoint & stamp, const std::string & frame_id)
  : T(data), stamp_(stamp), frame_id_(frame_id) {}

  void setData(const T & data) {static_cast<T &>(*this) = data;}
};

template<typename T>
bool operator==(const Stamped<T> & a, const Stamped<T> & b)
{
  return a.frame_id_ == b.frame_id_ && a.stamp_ == b.stamp_ &&
         static_cast<const T &>(a) == static_cast<const T &>(b);
}

/// The same with a 6x6 covariance matrix in row-major order.
template<typename T>
class WithCovarianceStamped : public Stamped<T>
{
public:
  std::array<std::array<double, 6>, 6> cov_mat_{};

  WithCovarianceStamped() = default;
  WithCovarianceStamped(
    const T & data, const TimePoint & stamp, const std::string & frame_id,
    const std::array<std::array<double, 6>, 6> & covariance)
  : Stamped<T>(data, stamp, frame_id), cov_mat_(covariance) {}
};

}  // namespace tf2
