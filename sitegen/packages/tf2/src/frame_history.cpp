#include "tf2/frame_history.hpp"

#include <algorithm>

namespace tf2
{
namespace detail
{
namespace
{

/// Interpolate between two samples, of which `newer` is the later one.
Sample between(const Sample & older, const Sample & newer, TimePoint time)
{
  const double ratio = static_cast<double>((time - older.stamp).count()) /
    static_cast<double>((newer.stamp - older.stamp).count());
  return {
    time, older.rotation.slerp(newer.rotation, ratio),
    older.translation.lerp(newer.translation, ratio), older.parent};
}

std::string why_not(TimePoint time, TimePoint oldest, TimePoint newest)
{
  const std::string wanted = displayTimePoint(time);
  const std::string extrapolation = "Lookup would require extrapolation ";
  if (oldest == newest) {
    return extrapolation + "at time " + wanted + ", but only time " + displayTimePoint(newest) +
           " is in the buffer";
  }
  if (time > newest) {
    return extrapolation + "into the future.  Requested time " + wanted +
           " but the latest data is at time " + displayTimePoint(newest);
  }
  return extrapolation + "into the past.  Requested time " + wanted +
         " but the earliest data is at time " + displayTimePoint(oldest);
}

}  // namespace

bool FrameHistory::insert(const Sample & sample)
{
  if (is_static_) {
    samples_.assign(1, sample);
    return true;
  }
  const TimePoint limit = newest() - kept_;
  while (!samples_.empty() && samples_.back().stamp < limit) {samples_.pop_back();}
  if (!samples_.empty() && sample.stamp < limit) {return false;}
  const auto not_after = [&](const Sample & each) {return each.stamp <= sample.stamp;};
  const auto place = std::find_if(samples_.begin(), samples_.end(), not_after);
  const auto older = std::find_if(
    place, samples_.end(), [&](const Sample & each) {return each.stamp < sample.stamp;});
  if (std::find(place, older, sample) == older) {samples_.insert(place, sample);}
  return true;
}

std::optional<Sample> FrameHistory::at(TimePoint time, std::string * error) const
{
  if (samples_.empty()) {return std::nullopt;}
  if (is_static_ || time == TimePointZero) {
    Sample sample = samples_.front();
    if (is_static_) {sample.stamp = time;}
    return sample;
  }
  const auto older = std::find_if(
    samples_.begin(), samples_.end(), [&](const Sample & each) {return each.stamp <= time;});
  if (older != samples_.end() && older->stamp == time) {return *older;}
  if (older == samples_.end() || older == samples_.begin()) {
    if (error) {*error = why_not(time, oldest(), newest());}
    return std::nullopt;
  }
  const auto newer = std::prev(older);
  return newer->parent == older->parent ? between(*older, *newer, time) : *older;
}

TimePoint FrameHistory::newest() const
{
  return is_static_ || samples_.empty() ? TimePointZero : samples_.front().stamp;
}

TimePoint FrameHistory::oldest() const
{
  return is_static_ || samples_.empty() ? TimePointZero : samples_.back().stamp;
}

}  // namespace detail
}  // namespace tf2
