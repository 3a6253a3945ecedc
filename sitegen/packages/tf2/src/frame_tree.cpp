// The search for a path between two frames.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "tf2/buffer_core.hpp"

namespace tf2
{

const detail::FrameHistory * BufferCore::history(CompactFrameID frame) const
{
  return frame < histories_.size() ? histories_[frame].get() : nullptr;
}

CompactFrameID BufferCore::number(const std::string & frame) const
{
  const auto found = numbers_.find(frame);
  return found == numbers_.end() ? 0 : found->second;
}

CompactFrameID BufferCore::number_or_new(const std::string & frame)
{
  const auto [place, is_new] = numbers_.emplace(frame, names_.size());
  if (is_new) {
    names_.push_back(frame);
    histories_.emplace_back();
    authorities_.emplace_back();
  }
  return place->second;
}

CompactFrameID BufferCore::valid_number(const char * what, const std::string & frame) const
{
  const std::string argument = "Invalid argument \"" + frame + "\" passed to " + what;
  if (frame.empty()) {
    throw InvalidArgumentException(argument + " - in tf2 frame_ids cannot be empty");
  }
  if (frame[0] == '/') {
    throw InvalidArgumentException(argument + " - in tf2 frame_ids cannot start with a '/'");
  }
  const CompactFrameID found = number(frame);
  if (found == 0) {
    throw LookupException("\"" + frame + "\" passed to " + what + " does not exist. ");
  }
  return found;
}

CompactFrameID BufferCore::valid_number(
  const char * what, const std::string & frame, std::string * error) const
{
  const char * reason = "frame does not exist";
  if (frame.empty()) {
    reason = "in tf2 frame_ids cannot be empty";
  } else if (frame[0] == '/') {
    reason = "in tf2 frame_ids cannot start with a '/'";
  } else if (const CompactFrameID found = number(frame)) {
    return found;
  }
  const std::string text = "Invalid frame ID \"" + frame + "\" passed to " + what + " - " + reason;
  if (error) {
    *error = text;
  } else {
    std::fprintf(stderr, "Warning: %s\n", text.c_str());
  }
  return 0;
}

BufferCore::Climb BufferCore::climb(
  CompactFrameID from, const std::vector<CompactFrameID> & stops, TimePoint time) const
{
  Climb climb;
  for (CompactFrameID frame = from;; ) {
    climb.frames.push_back(frame);
    climb.met = std::find(stops.begin(), stops.end(), frame) != stops.end();
    const auto * known = history(frame);
    if (climb.met || !known) {return climb;}
    const auto sample = known->at(time, &climb.error);
    climb.failed = !sample;
    climb.loops = climb.frames.size() > MAX_GRAPH_DEPTH;
    if (climb.failed || climb.loops) {return climb;}
    climb.transform = Transform(sample->rotation, sample->translation) * climb.transform;
    frame = sample->parent;
  }
}

TF2Error BufferCore::find(
  CompactFrameID target, CompactFrameID source, TimePoint time, Found * found,
  std::string * error) const
{
  const auto fail = [error](TF2Error code, const std::string & text) {
      if (error) {*error = text;}
      return code;
    };
  if (source == target) {
    if (found) {*found = {Transform::getIdentity(), time};}
    return TF2Error::TF2_NO_ERROR;
  }
  if (time == TimePointZero) {
    const TF2Error code = latest_common_time(target, source, time, error);
    if (code != TF2Error::TF2_NO_ERROR) {return code;}
  }
  const Climb up = climb(source, {target}, time);
  if (up.loops) {return fail(TF2Error::TF2_LOOKUP_ERROR, loop());}
  Climb other;
  if (!up.met) {
    other = climb(target, {source, up.frames.back()}, time);
    if (other.loops) {return fail(TF2Error::TF2_LOOKUP_ERROR, loop());}
    if (other.failed || (!other.met && up.failed)) {
      const std::string & reason = other.failed ? other.error : up.error;
      return fail(TF2Error::TF2_EXTRAPOLATION_ERROR, between(reason, target, source));
    }
    if (!other.met) {
      return fail(TF2Error::TF2_CONNECTIVITY_ERROR, unconnected(target, source));
    }
  }
  if (found && other.met && other.frames.back() == source) {
    *found = {other.transform.inverse(), time};
  } else if (found) {
    *found = {other.transform.inverse() * up.transform, time};
  }
  return TF2Error::TF2_NO_ERROR;
}

bool BufferCore::can_find(
  CompactFrameID target, CompactFrameID source, TimePoint time, std::string * error) const
{
  return find(target, source, time, nullptr, error) == TF2Error::TF2_NO_ERROR;
}

TF2Error BufferCore::latest_common_time(
  CompactFrameID target, CompactFrameID source, TimePoint & time, std::string * error) const
{
  // Static transforms do not limit the time.
  const auto limit = [this](const std::vector<CompactFrameID> & frames) {
      TimePoint common = TimePoint::max();
      for (const CompactFrameID frame : frames) {
        const auto * known = history(frame);
        const TimePoint newest = known ? known->newest() : TimePointZero;
        if (newest != TimePointZero) {common = std::min(common, newest);}
      }
      return common;
    };
  const auto ancestors = [this](CompactFrameID frame) {
      std::vector<CompactFrameID> found;
      while (frame != 0 && found.size() <= MAX_GRAPH_DEPTH) {
        found.push_back(frame);
        const auto * known = history(frame);
        frame = known ? known->parent() : 0;
      }
      return found;
    };
  auto up = ancestors(source);
  auto other = ancestors(target);
  if (std::max(up.size(), other.size()) > MAX_GRAPH_DEPTH) {
    if (error) {*error = loop();}
    return TF2Error::TF2_LOOKUP_ERROR;
  }
  const auto shared = std::find_first_of(up.begin(), up.end(), other.begin(), other.end());
  if (shared == up.end()) {
    if (error) {*error = unconnected(target, source);}
    return TF2Error::TF2_CONNECTIVITY_ERROR;
  }
  const CompactFrameID top = *shared;
  up.erase(shared, up.end());
  other.erase(std::find(other.begin(), other.end(), top), other.end());
  const TimePoint common = std::min(limit(up), limit(other));
  time = common == TimePoint::max() ? TimePointZero : common;
  return TF2Error::TF2_NO_ERROR;
}

std::vector<CompactFrameID> BufferCore::chain(
  const std::string & target, const std::string & source, TimePoint time) const
{
  const CompactFrameID to = valid_number("_chainAsVector argument target_frame", target);
  const CompactFrameID from = valid_number("_chainAsVector argument source_frame", source);
  look_up(target, source, time);  // throws where there is no way
  if (time == TimePointZero) {latest_common_time(to, from, time, nullptr);}
  Climb up = climb(from, {to}, time);
  if (up.met) {return up.frames;}
  const Climb other = climb(to, up.frames, time);
  up.frames.erase(
    std::find(up.frames.begin(), up.frames.end(), other.frames.back()), up.frames.end());
  up.frames.insert(up.frames.end(), other.frames.rbegin(), other.frames.rend());
  return up.frames;
}

void BufferCore::_chainAsVector(
  const std::string & target_frame, TimePoint target_time, const std::string & source_frame,
  TimePoint source_time, const std::string & fixed_frame, std::vector<std::string> & output) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  output.clear();
  for (const CompactFrameID frame : chain(fixed_frame, source_frame, source_time)) {
    output.push_back(names_[frame]);
  }
  const auto rest = chain(target_frame, fixed_frame, target_time);
  for (auto frame = std::next(rest.begin()); frame < rest.end(); ++frame) {
    output.push_back(names_[*frame]);
  }
}

std::vector<std::string> BufferCore::getAllFrameNames() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return {std::next(names_.begin()), names_.end()};
}

bool BufferCore::_frameExists(const std::string & frame) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return numbers_.count(frame) != 0;
}

bool BufferCore::_getParent(const std::string & frame, TimePoint time, std::string & parent) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto * known = history(number(frame));
  const auto sample = known ? known->at(time, nullptr) : std::nullopt;
  if (!sample) {return false;}
  parent = names_[sample->parent];
  return true;
}

CompactFrameID BufferCore::_lookupFrameNumber(const std::string & frame) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return number(frame);
}

CompactFrameID BufferCore::_lookupOrInsertFrameNumber(const std::string & frame)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return number_or_new(frame);
}

TF2Error BufferCore::_getLatestCommonTime(
  CompactFrameID target, CompactFrameID source, TimePoint & time, std::string * error) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return latest_common_time(target, source, time, error);
}

CompactFrameID BufferCore::_validateFrameId(
  const char * function_name, const std::string & frame) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return valid_number(function_name, frame);
}

}  // namespace tf2
