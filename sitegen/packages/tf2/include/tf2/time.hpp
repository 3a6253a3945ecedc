#pragma once

#include <chrono>
#include <string>

namespace tf2
{

using Duration = std::chrono::nanoseconds;
using TimePoint = std::chrono::time_point<std::chrono::system_clock, Duration>;
using IDuration = std::chrono::duration<int, std::nano>;

/// Requests the latest time at which a transform is available.
const TimePoint TimePointZero = TimePoint(IDuration::zero());

TimePoint get_now();
Duration durationFromSec(double seconds);
TimePoint timeFromSec(double seconds);
double durationToSec(const Duration & duration);
double timeToSec(const TimePoint & time);
/// In seconds, with six digits after the point.
std::string displayTimePoint(const TimePoint & time);

}  // namespace tf2
