// Functions on angles in radians.
#pragma once

#include <algorithm>
#include <cmath>

namespace angles
{

static inline double from_degrees(double degrees)
{
  return degrees * M_PI / 180.0;
}

static inline double to_degrees(double radians)
{
  return radians * 180.0 / M_PI;
}

// Return the equal angle in [0, 2π].
static inline double normalize_angle_positive(double angle)
{
  const double rest = std::fmod(angle, 2.0 * M_PI);
  return rest < 0 ? rest + 2.0 * M_PI : rest;
}

// Return the equal angle in (-π, π].
static inline double normalize_angle(double angle)
{
  const double rest = std::fmod(angle + M_PI, 2.0 * M_PI);
  return rest <= 0.0 ? rest + M_PI : rest - M_PI;
}

// Return the shortest turn from one angle to another, in (-π, π].
static inline double shortest_angular_distance(double from, double to)
{
  return normalize_angle(to - from);
}

// Return the turn in [-2π, 2π] that ends where `angle` does, in the other direction.
static inline double two_pi_complement(double angle)
{
  if (std::fabs(angle) > 2.0 * M_PI) {
    angle = std::fmod(angle, 2.0 * M_PI);
  }
  return angle > 0 ? angle - 2.0 * M_PI : angle + 2.0 * M_PI;
}

// Find the least (negative) and the greatest turn from `from` that stay within the interval from
// `left_limit` to `right_limit`, in the positive direction; both limits are in [-π, π]. Return false
// if `from` is not in the interval: then the turns are those that reach it.
static inline bool find_min_max_delta(
  double from, double left_limit, double right_limit, double & result_min_delta,
  double & result_max_delta)
{
  const double left = shortest_angular_distance(from, left_limit);
  const double right = shortest_angular_distance(from, right_limit);
  // Both limits can be reached in both directions.
  const auto to_left = std::minmax({left, two_pi_complement(left)});
  const auto to_right = std::minmax({right, two_pi_complement(right)});
  if (left == 0 || right == 0) {
    result_min_delta = left == 0 ? 0 : to_left.first;
    result_max_delta = left == 0 ? to_right.second : 0;
    return true;
  }
  const bool inside = to_left.first > to_right.first && to_right.second < to_left.second;
  result_min_delta = inside ? to_left.first : to_right.first;
  result_max_delta = inside ? to_right.second : to_left.second;
  return inside || (left_limit == -M_PI && right_limit == M_PI);
}

// Find the shortest turn between two angles that stays within the interval from `left_limit` to
// `right_limit`, in the positive direction; both limits are in [-π, π]. Return false if an angle is
// not in the interval.
static inline bool shortest_angular_distance_with_limits(
  double from, double to, double left_limit, double right_limit, double & shortest_angle)
{
  double least, greatest;
  const bool inside = find_min_max_delta(from, left_limit, right_limit, least, greatest);
  const double near = shortest_angular_distance(from, to);
  const double far = two_pi_complement(near);
  for (const double turn : {near, far}) {
    if (inside && least <= turn && turn <= greatest) {
      shortest_angle = turn;
      return true;
    }
  }
  // Cross the limit that is next to the angle outside.
  if (inside) {
    find_min_max_delta(to, left_limit, right_limit, least, greatest);
  }
  const double before = std::fabs(least), after = std::fabs(greatest);
  if (before == after) {
    shortest_angle = std::fabs(near) < std::fabs(far) ? near : far;
  } else {
    shortest_angle = (before < after) == inside ? std::max(near, far) : std::min(near, far);
  }
  return false;
}

// Find the shortest turn from `from` to an angle that is equal to `to`, within limits of any size.
// Return false if there is none, if `from` is not within them, or if left_limit > right_limit.
static inline bool shortest_angular_distance_with_large_limits(
  double from, double to, double left_limit, double right_limit, double & shortest_angle)
{
  const auto is_allowed = [=](double angle) {return left_limit <= angle && angle <= right_limit;};
  const double distance = shortest_angular_distance(from, to);
  const double other = two_pi_complement(distance);
  const bool is_short = std::fabs(distance) <= std::fabs(other);
  const double near = is_short ? distance : other;
  const double far = is_short ? other : distance;
  shortest_angle = !is_allowed(from + near) && is_allowed(from + far) ? far : near;
  return is_allowed(from) && is_allowed(from + shortest_angle);
}

}  // namespace angles
