#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "tf2/LinearMath/Transform.hpp"
#include "tf2/buffer_core_interface.hpp"
#include "tf2/exceptions.hpp"
#include "tf2/frame_history.hpp"
#include "tf2/time.hpp"
#include "tf2/transform_datatypes.hpp"
#include "tf2/visibility_control.h"

namespace tf2
{

using P_TimeAndFrameID = std::pair<TimePoint, CompactFrameID>;
using TransformableRequestHandle = std::uint64_t;

enum TransformableResult
{
  TransformAvailable,
  TransformFailure,
};

using TransformableCallback = std::function<void (
      TransformableRequestHandle request_handle, const std::string & target_frame,
      const std::string & source_frame, TimePoint time, TransformableResult result)>;

static constexpr Duration BUFFER_CORE_DEFAULT_CACHE_TIME = std::chrono::seconds(10);

/// A tree of frames with their transforms over time; each frame has one parent.
class BufferCore : public BufferCoreInterface
{
public:
  static const std::uint32_t MAX_GRAPH_DEPTH = 1000;
  using TransformableCallback = tf2::TransformableCallback;

  explicit BufferCore(Duration cache_time = BUFFER_CORE_DEFAULT_CACHE_TIME)
  : cache_time_(cache_time) {}

  void clear() override;
  /// False, with a message in the log, if the transform is invalid or too old.
  bool setTransform(
    const geometry_msgs::msg::TransformStamped & transform, const std::string & authority,
    bool is_static = false);

  /// The transform from the source frame to the target frame.
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target_frame, const std::string & source_frame,
    const TimePoint & time) const override;
  /// The transform between two times; `fixed_frame` does not move in between.
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target_frame, const TimePoint & target_time,
    const std::string & source_frame, const TimePoint & source_time,
    const std::string & fixed_frame) const override;
  bool canTransform(
    const std::string & target_frame, const std::string & source_frame, const TimePoint & time,
    std::string * error_msg = nullptr) const override;
  bool canTransform(
    const std::string & target_frame, const TimePoint & target_time,
    const std::string & source_frame, const TimePoint & source_time,
    const std::string & fixed_frame, std::string * error_msg = nullptr) const override;

  std::vector<std::string> getAllFrameNames() const override;
  std::string allFramesAsYAML(TimePoint current_time) const;
  std::string allFramesAsYAML() const {return allFramesAsYAML(TimePointZero);}
  std::string allFramesAsString() const;
  Duration getCacheLength() const {return cache_time_;}

  /// Run the callback once the transform is available, or can no longer become available. Returns 0
  /// if it is available already, and 0xffffffffffffffff if it never will be; then the callback does
  /// not run.
  TransformableRequestHandle addTransformableRequest(
    const TransformableCallback & callback, const std::string & target_frame,
    const std::string & source_frame, TimePoint time);
  void cancelTransformableRequest(TransformableRequestHandle handle);

  /// Tell the buffer that another thread adds transforms, so that waiting for them makes sense.
  void setUsingDedicatedThread(bool value) {using_dedicated_thread_ = value;}
  bool isUsingDedicatedThread() const {return using_dedicated_thread_;}

  bool _frameExists(const std::string & frame) const;
  bool _getParent(const std::string & frame, TimePoint time, std::string & parent) const;
  void _getFrameStrings(std::vector<std::string> & frames) const {frames = getAllFrameNames();}
  CompactFrameID _lookupFrameNumber(const std::string & frame) const;
  CompactFrameID _lookupOrInsertFrameNumber(const std::string & frame);
  TF2Error _getLatestCommonTime(
    CompactFrameID target, CompactFrameID source, TimePoint & time, std::string * error) const;
  CompactFrameID _validateFrameId(const char * function_name, const std::string & frame) const;
  /// The frames from the source to the target, through the fixed frame.
  void _chainAsVector(
    const std::string & target_frame, TimePoint target_time, const std::string & source_frame,
    TimePoint source_time, const std::string & fixed_frame,
    std::vector<std::string> & output) const;

private:
  struct Request
  {
    TransformableCallback callback;
    std::string target;
    std::string source;
    TimePoint time;
  };

  /// A path from a frame upwards: its frames, and the transform from the first to the last.
  struct Climb
  {
    std::vector<CompactFrameID> frames;
    Transform transform = Transform::getIdentity();
    bool met = false;
    bool failed = false;
    bool loops = false;
    std::string error;
  };

  /// A transform and its time.
  struct Found
  {
    Transform transform;
    TimePoint time;
  };

  // The caller must hold mutex_.
  const detail::FrameHistory * history(CompactFrameID frame) const;
  CompactFrameID number(const std::string & frame) const;
  CompactFrameID number_or_new(const std::string & frame);
  CompactFrameID valid_number(const char * what, const std::string & frame) const;
  CompactFrameID valid_number(
    const char * what, const std::string & frame, std::string * error) const;
  Climb climb(
    CompactFrameID from, const std::vector<CompactFrameID> & stops, TimePoint time) const;
  TF2Error latest_common_time(
    CompactFrameID target, CompactFrameID source, TimePoint & time, std::string * error) const;
  TF2Error find(
    CompactFrameID target, CompactFrameID source, TimePoint time, Found * found,
    std::string * error) const;
  Found look_up(const std::string & target, const std::string & source, TimePoint time) const;
  bool can_find(
    CompactFrameID target, CompactFrameID source, TimePoint time, std::string * error) const;
  std::string between(
    const std::string & error, CompactFrameID target, CompactFrameID source) const;
  std::string unconnected(CompactFrameID target, CompactFrameID source) const;
  std::string loop() const;
  std::string frames_as_string() const;
  std::vector<CompactFrameID> chain(
    const std::string & target, const std::string & source, TimePoint time) const;
  /// Whether a request is finished, and its result.
  std::optional<TransformableResult> outcome(const Request & request) const;

  void answer_requests();

  Duration cache_time_;
  mutable std::mutex mutex_;
  // Indexed by the number of the frame; a frame that is only a parent has no history.
  std::vector<std::string> names_{"NO_PARENT"};
  std::vector<std::unique_ptr<detail::FrameHistory>> histories_ = std::vector<std::unique_ptr<detail::FrameHistory>>(1);
  std::vector<std::string> authorities_{""};
  std::unordered_map<std::string, CompactFrameID> numbers_{{"NO_PARENT", 0}};
  std::map<TransformableRequestHandle, Request> requests_;
  TransformableRequestHandle last_request_ = 0;
  bool using_dedicated_thread_ = false;
};

}  // namespace tf2
