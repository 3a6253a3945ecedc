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

/// Frames are numbered; 0 is none.
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
  /// False if it is older than what is kept.
  bool insert(const Sample & sample);
  /// The frame at `time`, in between two samples where none is of this time; at TimePointZero the
  /// newest. Where there is none, `error` (if it is not null) says why.
  std::optional<Sample> at(TimePoint time, std::string * error) const;
  void clear() {samples_.clear();}

  std::size_t size() const {return samples_.size();}
  /// The newest parent, or 0.
  CompactFrameID parent() const {return samples_.empty() ? 0 : samples_.front().parent;}
  /// TimePointZero where nothing is known, or all is true at any time.
  TimePoint newest() const;
  TimePoint oldest() const;

private:
  bool is_static_;
  Duration kept_;
  std::deque<Sample> samples_;  // the newest first
};

}  // namespace detail
}  // namespace tf2
