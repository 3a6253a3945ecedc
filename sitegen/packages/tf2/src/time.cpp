#include "tf2/time.hpp"

#include <cstdio>

namespace tf2
{

TimePoint get_now()
{
  return std::chrono::time_point_cast<Duration>(std::chrono::system_clock::now());
}

Duration durationFromSec(double seconds)
{
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

TimePoint timeFromSec(double seconds) {return TimePoint(durationFromSec(seconds));}

double durationToSec(const Duration & duration)
{
  return std::chrono::duration<double>(duration).count();
}

double timeToSec(const TimePoint & time) {return durationToSec(time.time_since_epoch());}

std::string displayTimePoint(const TimePoint & time)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.6f", timeToSec(time));
  return text;
}

}  // namespace tf2
