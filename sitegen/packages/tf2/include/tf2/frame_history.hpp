// The history of one frame: its transforms to its parent, by time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "tf2/LinearMath/Quaternion.hpp"
#include "tf2/LinearMath/Vector3.hpp"
#include "tf2/time.hpp"

namespace tf2
{

/// The number of a frame; 0 means none.
using CompactFrameID = std::uint32_t;

namespace detail
{

struct Sample
{
  TimePoint stamp;
  Quaternion rotation;
  Vector3 translation;
  CompactFrameID parent;

  bool operator==(const Sample & other) const
  {
    return stamp == other.stamp && rotation == other.rotation &&
           translation == other.translation && parent == other.parent;
  }
};

class FrameHistory
{
public:
  FrameHistory(bool is_static, Duration kept)
  : is_static_(is_static), kept_(kept) {}

  bool is_static() const {return is_static_;}
  /// False if it is older than the history.
  bool insert(const Sample & sample);
  /// The transform at `time`, interpolated between samples; the newest one at TimePointZero. If
  /// there is none, `error` (unless it is null) receives the reason.
  std::optional<Sample> at(TimePoint time, std::string * error) const;
  void clear() {samples_.clear();}

  std::size_t size() const {return samples_.size();}
  /// The newest parent, or 0.
  CompactFrameID parent() const {return samples_.empty() ? 0 : samples_.front().parent;}
  /// TimePointZero if the history is empty or static.
  TimePoint newest() const;
  TimePoint oldest() const;

private:
  bool is_static_;
  Duration kept_;
  std::deque<Sample> samples_;  // the newest first
};

}  // namespace detail
}  // namespace tf2
