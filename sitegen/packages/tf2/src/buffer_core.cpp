#include "tf2/buffer_core.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tf2
{
namespace
{

/// The tolerance for the squared length of a quaternion, which should be 1.
constexpr double kTolerance = 10e-3;
constexpr TransformableRequestHandle kNever = 0xffffffffffffffffULL;

std::string without_slash(const std::string & frame)
{
  return frame.substr(frame.empty() || frame[0] != '/' ? 0 : 1);
}

TimePoint time_of(const builtin_interfaces::msg::Time & stamp)
{
  return TimePoint(std::chrono::seconds(stamp.sec) + std::chrono::nanoseconds(stamp.nanosec));
}

/// Why a transform is invalid, one line for each reason.
std::vector<std::string> faults(
  const geometry_msgs::msg::Transform & transform, const std::string & parent,
  const std::string & child, const std::string & authority)
{
  const auto & t = transform.translation;
  const auto & r = transform.rotation;
  std::vector<std::string> found;
  if (child == parent) {
    found.push_back(
      "TF_SELF_TRANSFORM: Ignoring transform from authority \"" + authority +
      "\" with frame_id and  child_frame_id \"" + child + "\" because they are the same");
  }
  if (child.empty()) {
    found.push_back(
      "TF_NO_CHILD_FRAME_ID: Ignoring transform from authority \"" + authority +
      "\" because child_frame_id not set ");
  }
  if (parent.empty()) {
    found.push_back(
      "TF_NO_FRAME_ID: Ignoring transform with child_frame_id \"" + child +
      "\"  from authority \"" + authority + "\" because frame_id not set");
  }
  char numbers[256];
  std::snprintf(numbers, sizeof(numbers), "(%f %f %f %f)", r.x, r.y, r.z, r.w);
  if (std::isnan(t.x + t.y + t.z + r.x + r.y + r.z + r.w)) {
    char place[192];
    std::snprintf(place, sizeof(place), "(%f %f %f) ", t.x, t.y, t.z);
    found.push_back(
      "TF_NAN_INPUT: Ignoring transform for child_frame_id \"" + child + "\" from authority \"" +
      authority + "\" because of a nan value in the transform " + place + numbers);
  }
  const double length = r.x * r.x + r.y * r.y + r.z * r.z + r.w * r.w;
  if (!(std::abs(length - 1) < kTolerance)) {
    found.push_back(
      "TF_DENORMALIZED_QUATERNION: Ignoring transform for child_frame_id \"" + child +
      "\" from authority \"" + authority + "\" because of an invalid quaternion in the transform " +
      numbers);
  }
  return found;
}

geometry_msgs::msg::TransformStamped stamped(
  const Transform & transform, TimePoint time, const std::string & target,
  const std::string & source)
{
  const Vector3 & t = transform.getOrigin();
  const Quaternion r = transform.getRotation();
  const auto nanoseconds = time.time_since_epoch().count();
  geometry_msgs::msg::TransformStamped message;
  message.header.stamp.sec = static_cast<std::int32_t>(nanoseconds / 1000000000);
  message.header.stamp.nanosec = static_cast<std::uint32_t>(nanoseconds % 1000000000);
  message.header.frame_id = target;
  message.child_frame_id = source;
  message.transform.translation.x = t.x();
  message.transform.translation.y = t.y();
  message.transform.translation.z = t.z();
  message.transform.rotation.x = r.x();
  message.transform.rotation.y = r.y();
  message.transform.rotation.z = r.z();
  message.transform.rotation.w = r.w();
  return message;
}

}  // namespace

void BufferCore::clear()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  for (auto & each : histories_) {
    if (each && !each->is_static()) {each->clear();}
  }
}

bool BufferCore::setTransform(
  const geometry_msgs::msg::TransformStamped & transform, const std::string & authority,
  bool is_static)
{
  const std::string parent = without_slash(transform.header.frame_id);
  const std::string child = without_slash(transform.child_frame_id);
  const auto wrong = faults(transform.transform, parent, child, authority);
  for (const std::string & line : wrong) {std::fprintf(stderr, "Error:   %s\n", line.c_str());}
  if (!wrong.empty()) {return false;}
  const auto & t = transform.transform.translation;
  const auto & r = transform.transform.rotation;
  const TimePoint stamp = time_of(transform.header.stamp);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const CompactFrameID frame = number_or_new(child);
    const CompactFrameID above = number_or_new(parent);
    auto & known = histories_[frame];
    if (!known || known->is_static() != is_static) {
      known = std::make_unique<detail::FrameHistory>(is_static, cache_time_);
    }
    const Quaternion rotation(r.x, r.y, r.z, r.w);
    if (!known->insert({stamp, rotation, Vector3(t.x, t.y, t.z), above})) {
      std::fprintf(
        stderr, "Warning: TF_OLD_DATA ignoring data from the past for frame %s at time %s "
        "according to authority %s\nPossible reasons are listed at "
        "http://wiki.ros.org/tf/Errors%%20explained\n", child.c_str(),
        displayTimePoint(stamp).c_str(), authority.c_str());
      return false;
    }
    authorities_[frame] = authority;
  }
  answer_requests();
  return true;
}

geometry_msgs::msg::TransformStamped BufferCore::lookupTransform(
  const std::string & target_frame, const std::string & source_frame, const TimePoint & time) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const Found found = look_up(target_frame, source_frame, time);
  return stamped(found.transform, found.time, target_frame, source_frame);
}

geometry_msgs::msg::TransformStamped BufferCore::lookupTransform(
  const std::string & target_frame, const TimePoint & target_time,
  const std::string & source_frame, const TimePoint & source_time,
  const std::string & fixed_frame) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  valid_number("lookupTransform argument target_frame", target_frame);
  valid_number("lookupTransform argument source_frame", source_frame);
  valid_number("lookupTransform argument fixed_frame", fixed_frame);
  const Found before = look_up(fixed_frame, source_frame, source_time);
  const Found after = look_up(target_frame, fixed_frame, target_time);
  const Transform both = after.transform * before.transform;
  return stamped(both, after.time, target_frame, source_frame);
}

BufferCore::Found BufferCore::look_up(
  const std::string & target, const std::string & source, TimePoint time) const
{
  if (target == source) {
    const auto * known = history(number(target));
    const bool latest = time == TimePointZero && known;
    return {Transform::getIdentity(), latest ? known->newest() : time};
  }
  const CompactFrameID to = valid_number("lookupTransform argument target_frame", target);
  const CompactFrameID from = valid_number("lookupTransform argument source_frame", source);
  Found found;
  std::string error;
  switch (find(to, from, time, &found, &error)) {
    case TF2Error::TF2_NO_ERROR: return found;
    case TF2Error::TF2_CONNECTIVITY_ERROR: throw ConnectivityException(error);
    case TF2Error::TF2_EXTRAPOLATION_ERROR: throw ExtrapolationException(error);
    default: throw LookupException(error);
  }
}

bool BufferCore::canTransform(
  const std::string & target_frame, const std::string & source_frame, const TimePoint & time,
  std::string * error_msg) const
{
  if (target_frame == source_frame) {return true;}
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto to = valid_number("canTransform argument target_frame", target_frame, error_msg);
  if (to == 0) {return false;}
  const auto from = valid_number("canTransform argument source_frame", source_frame, error_msg);
  return from != 0 && can_find(to, from, time, error_msg);
}

bool BufferCore::canTransform(
  const std::string & target_frame, const TimePoint & target_time,
  const std::string & source_frame, const TimePoint & source_time,
  const std::string & fixed_frame, std::string * error_msg) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto to = valid_number("canTransform argument target_frame", target_frame, error_msg);
  if (to == 0) {return false;}
  const auto from = valid_number("canTransform argument source_frame", source_frame, error_msg);
  if (from == 0) {return false;}
  const auto fixed = valid_number("canTransform argument fixed_frame", fixed_frame, error_msg);
  return fixed != 0 && can_find(to, fixed, target_time, error_msg) &&
         can_find(fixed, from, source_time, error_msg);
}

TransformableRequestHandle BufferCore::addTransformableRequest(
  const TransformableCallback & callback, const std::string & target_frame,
  const std::string & source_frame, TimePoint time)
{
  if (target_frame == source_frame) {return 0;}
  const std::lock_guard<std::mutex> lock(mutex_);
  Request request{callback, without_slash(target_frame), without_slash(source_frame), time};
  if (const auto result = outcome(request)) {
    return *result == TransformAvailable ? 0 : kNever;
  }
  requests_.emplace(++last_request_, std::move(request));
  return last_request_;
}

void BufferCore::cancelTransformableRequest(TransformableRequestHandle handle)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  requests_.erase(handle);
}

std::optional<TransformableResult> BufferCore::outcome(const Request & request) const
{
  const CompactFrameID target = number(request.target);
  const CompactFrameID source = number(request.source);
  if (target == 0 || source == 0) {return std::nullopt;}
  TimePoint latest = TimePointZero;
  latest_common_time(target, source, latest, nullptr);
  if (latest != TimePointZero && request.time + cache_time_ < latest) {return TransformFailure;}
  if (can_find(target, source, request.time, nullptr)) {return TransformAvailable;}
  return std::nullopt;
}

void BufferCore::answer_requests()
{
  std::vector<std::pair<TransformableRequestHandle, Request>> done;
  std::vector<TransformableResult> results;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (auto each = requests_.begin(); each != requests_.end(); ) {
      const auto result = outcome(each->second);
      if (result) {
        results.push_back(*result);
        done.emplace_back(each->first, std::move(each->second));
      }
      each = result ? requests_.erase(each) : std::next(each);
    }
  }
  // Called without the lock, because callbacks look up the transform.
  for (std::size_t i = 0; i < done.size(); ++i) {
    const auto & [handle, request] = done[i];
    request.callback(handle, request.target, request.source, request.time, results[i]);
  }
}

}  // namespace tf2
