#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "message_filters/connection.hpp"
#include "message_filters/message_traits.hpp"
#include "message_filters/simple_filter.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/buffer.hpp"

namespace tf2_ros
{

namespace filter_failure_reasons
{

enum FilterFailureReason
{
  Unknown,
  OutTheBack,
  EmptyFrameID,
  NoTransformFound,
  QueueFull,
  FilterFailureReasonCount,
};

}  // namespace filter_failure_reasons

using FilterFailureReason = filter_failure_reasons::FilterFailureReason;

inline std::string get_filter_failure_reason_string(FilterFailureReason reason)
{
  switch (reason) {
    case filter_failure_reasons::OutTheBack:
      return "the timestamp on the message is earlier than all the data in the transform cache";
    case filter_failure_reasons::EmptyFrameID:
      return "the frame id of the message is empty";
    case filter_failure_reasons::NoTransformFound:
      return "did not find a valid transform, this usually happens at startup ...";
    case filter_failure_reasons::QueueFull:
      return "discarding message because the queue is full";
    default:
      return "unknown";
  }
}

class MessageFilterBase
{
public:
  using V_string = std::vector<std::string>;

  virtual ~MessageFilterBase() = default;
  virtual void clear() = 0;
  virtual void setTargetFrame(const std::string & target_frame) = 0;
  virtual void setTargetFrames(const V_string & target_frames) = 0;
  virtual void setTolerance(const rclcpp::Duration & tolerance) = 0;
};

/// Passes on each message once it can be transformed to all target frames.
template<class M, class BufferT = Buffer>
class MessageFilter : public MessageFilterBase, public message_filters::SimpleFilter<M>
{
public:
  using MConstPtr = std::shared_ptr<M const>;
  using MEvent = message_filters::MessageEvent<M const>;

  /// The queue is unlimited if its size is 0. Messages wait up to `buffer_timeout`.
  MessageFilter(
    BufferT & buffer, const std::string & target_frame, std::uint32_t queue_size,
    rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr node_logging,
    rclcpp::node_interfaces::NodeClockInterface::SharedPtr node_clock,
    tf2::Duration buffer_timeout = tf2::Duration::max())
  : logging_(std::move(node_logging)), clock_(std::move(node_clock)), buffer_(buffer),
    size_(queue_size), timeout_(buffer_timeout)
  {
    setTargetFrame(target_frame);
  }
  MessageFilter(
    BufferT & buffer, const std::string & target_frame, std::uint32_t queue_size,
    const rclcpp::Node::SharedPtr & node, tf2::Duration buffer_timeout = tf2::Duration::max())
  : MessageFilter(
      buffer, target_frame, queue_size, node->get_node_logging_interface(),
      node->get_node_clock_interface(), buffer_timeout) {}
  template<class F>
  MessageFilter(
    F & filter, BufferT & buffer, const std::string & target_frame, std::uint32_t queue_size,
    rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr node_logging,
    rclcpp::node_interfaces::NodeClockInterface::SharedPtr node_clock,
    tf2::Duration buffer_timeout = tf2::Duration::max())
  : MessageFilter(
      buffer, target_frame, queue_size, std::move(node_logging), std::move(node_clock),
      buffer_timeout)
  {
    connectInput(filter);
  }
  template<class F>
  MessageFilter(
    F & filter, BufferT & buffer, const std::string & target_frame, std::uint32_t queue_size,
    const rclcpp::Node::SharedPtr & node, tf2::Duration buffer_timeout = tf2::Duration::max())
  : MessageFilter(
      filter, buffer, target_frame, queue_size, node->get_node_logging_interface(),
      node->get_node_clock_interface(), buffer_timeout) {}
  ~MessageFilter() override
  {
    connection_.disconnect();
    clear();
  }

  template<class F>
  void connectInput(F & filter)
  {
    connection_.disconnect();
    connection_ = filter.registerCallback([this](const MEvent & event) {add(event);});
  }
  void setTargetFrame(const std::string & target_frame) override
  {
    setTargetFrames({target_frame});
  }
  void setTargetFrames(const V_string & target_frames) override
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    frames_.clear();
    for (const std::string & frame : target_frames) {frames_.push_back(without_slash(frame));}
  }
  std::string getTargetFramesString()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::string text;
    for (const std::string & frame : frames_) {text += frame + " ";}
    return text;
  }
  /// The transforms must be available at the time of the message and at this time after it.
  void setTolerance(const rclcpp::Duration & tolerance) override
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    tolerance_ = tolerance;
  }
  virtual void setQueueSize(std::uint32_t new_queue_size) {size_ = new_queue_size;}
  virtual std::uint32_t getQueueSize() {return size_;}

  void clear() override
  {
    std::list<Waiting> all;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      all.swap(waiting_);
    }
    for (const Waiting & each : all) {forget(each);}
  }

  void add(const MConstPtr & message) {add(MEvent(message, clock_->get_clock()->now()));}
  void add(const MEvent & event)
  {
    const M & message = *event.getConstMessage();
    const std::string frame = without_slash(message_filters::message_traits::FrameId<M>::value(message));
    if (frame.empty()) {
      drop(event, filter_failure_reasons::EmptyFrameID);
      return;
    }
    const auto stamp = fromRclcpp(message_filters::message_traits::TimeStamp<M>::value(message));
    std::vector<std::pair<std::string, tf2::TimePoint>> wanted;
    const std::uint64_t number = keep(event, stamp, wanted);
    for (const auto & [target, time] : wanted) {
      const auto future = buffer_.waitForTransform(
        target, frame, time, timeout_,
        [this, number](const TransformStampedFuture & answer) {arrived(number, answer);});
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto place = find(number);
      if (place != waiting_.end()) {place->futures.push_back(future);}
    }
  }

private:
  struct Waiting
  {
    std::uint64_t number;
    MEvent event;
    std::size_t missing;
    std::vector<TransformStampedFuture> futures;
  };

  static std::string without_slash(const std::string & frame)
  {
    return frame.substr(frame.empty() || frame[0] != '/' ? 0 : 1);
  }

  typename std::list<Waiting>::iterator find(std::uint64_t number)
  {
    return std::find_if(
      waiting_.begin(), waiting_.end(), [&](const Waiting & each) {
        return each.number == number;
      });
  }

  /// Add `event` to the queue, in place of the oldest one if it is full, and request its
  /// transforms.
  std::uint64_t keep(
    const MEvent & event, tf2::TimePoint stamp,
    std::vector<std::pair<std::string, tf2::TimePoint>> & wanted)
  {
    std::list<Waiting> removed;
    std::uint64_t number;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      for (const std::string & target : frames_) {
        wanted.emplace_back(target, stamp);
        if (tolerance_.nanoseconds() != 0) {
          wanted.emplace_back(target, stamp + fromRclcpp(tolerance_));
        }
      }
      if (size_ != 0 && waiting_.size() >= size_) {
        removed.splice(removed.begin(), waiting_, waiting_.begin());
      }
      number = ++last_;
      waiting_.push_back({number, event, wanted.size(), {}});
    }
    for (const Waiting & each : removed) {
      forget(each);
      drop(each.event, filter_failure_reasons::QueueFull);
    }
    return number;
  }

  void arrived(std::uint64_t number, const TransformStampedFuture & answer)
  {
    bool there = true;
    try {
      answer.get();
    } catch (const tf2::TransformException &) {
      there = false;
    }
    std::list<Waiting> done;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto place = find(number);
      if (place == waiting_.end() || (there && --place->missing > 0)) {return;}
      done.splice(done.begin(), waiting_, place);
    }
    if (there) {
      this->signalMessage(done.front().event);
    } else {
      forget(done.front());
      drop(done.front().event, reason(done.front().event));
    }
  }

  void forget(const Waiting & waiting)
  {
    for (const TransformStampedFuture & future : waiting.futures) {buffer_.cancel(future);}
  }

  FilterFailureReason reason(const MEvent & event)
  {
    const M & message = *event.getConstMessage();
    const auto stamp = fromRclcpp(message_filters::message_traits::TimeStamp<M>::value(message));
    const std::string frame = message_filters::message_traits::FrameId<M>::value(message);
    for (const std::string & target : frames_) {
      try {
        const auto latest = buffer_.lookupTransform(target, frame, tf2::TimePointZero);
        if (fromMsg(latest.header.stamp) > stamp + buffer_.getCacheLength()) {
          return filter_failure_reasons::OutTheBack;
        }
      } catch (const tf2::TransformException &) {
        return filter_failure_reasons::NoTransformFound;
      }
    }
    return filter_failure_reasons::Unknown;
  }

  void drop(const MEvent & event, FilterFailureReason why)
  {
    const M & message = *event.getConstMessage();
    RCLCPP_INFO(
      logging_->get_logger(),
      "Message Filter dropping message: frame '%s' at time %.3f for reason '%s'",
      message_filters::message_traits::FrameId<M>::value(message).c_str(),
      message_filters::message_traits::TimeStamp<M>::value(message).seconds(),
      get_filter_failure_reason_string(why).c_str());
  }

  rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr logging_;
  rclcpp::node_interfaces::NodeClockInterface::SharedPtr clock_;
  BufferT & buffer_;
  std::uint32_t size_;
  tf2::Duration timeout_;
  rclcpp::Duration tolerance_{0, 0};
  std::vector<std::string> frames_;
  std::mutex mutex_;
  std::list<Waiting> waiting_;  // the oldest first
  std::uint64_t last_ = 0;
  message_filters::Connection connection_;
};

}  // namespace tf2_ros
