#pragma once

#include <algorithm>
#include <deque>
#include <memory>
#include <mutex>
#include <vector>

#include "message_filters/message_traits.hpp"
#include "message_filters/simple_filter.hpp"
#include "rclcpp/time.hpp"

namespace message_filters
{

/// Keeps the last messages ordered by time, and passes each on.
template<class M>
class Cache : public SimpleFilter<M>
{
public:
  using MConstPtr = std::shared_ptr<M const>;
  using EventType = MessageEvent<M const>;

  template<class F>
  explicit Cache(F & filter, unsigned int cache_size = 1)
  : Cache(cache_size)
  {
    connectInput(filter);
  }
  explicit Cache(unsigned int cache_size = 1) {setCacheSize(cache_size);}
  ~Cache() {connection_.disconnect();}

  template<class F>
  void connectInput(F & filter)
  {
    connection_.disconnect();
    connection_ = filter.registerCallback([this](const EventType & event) {add(event);});
  }
  void setCacheSize(unsigned int cache_size)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    size_ = std::max(cache_size, 1u);
    while (messages_.size() > size_) {messages_.pop_front();}
  }
  void add(const MConstPtr & message) {add(EventType(message));}
  void add(const EventType & event)
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      while (messages_.size() >= size_) {messages_.pop_front();}
      messages_.insert(first_after(time_of(event.getConstMessage())), event.getConstMessage());
    }
    this->signalMessage(event);
  }

  /// The messages from `start` to `end`, both included.
  std::vector<MConstPtr> getInterval(const rclcpp::Time & start, const rclcpp::Time & end) const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto first = first_from(start);
    return first <= first_after(end) ? std::vector<MConstPtr>(first, first_after(end)) :
           std::vector<MConstPtr>();
  }
  /// The same with the message before and the message after the interval, if they exist.
  std::vector<MConstPtr> getSurroundingInterval(
    const rclcpp::Time & start, const rclcpp::Time & end) const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    auto first = first_after(start);
    if (first != messages_.begin()) {--first;}
    auto last = first_from(end);
    if (last != messages_.end()) {++last;}
    return first <= last ? std::vector<MConstPtr>(first, last) : std::vector<MConstPtr>();
  }
  /// Null if there is no message before, or after. The times of an empty cache are zero.
  MConstPtr getElemBeforeTime(const rclcpp::Time & time) const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto place = first_from(time);
    return place == messages_.begin() ? nullptr : *std::prev(place);
  }
  MConstPtr getElemAfterTime(const rclcpp::Time & time) const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto place = first_after(time);
    return place == messages_.end() ? nullptr : *place;
  }
  rclcpp::Time getLatestTime() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return messages_.empty() ? zero() : time_of(messages_.back());
  }
  rclcpp::Time getOldestTime() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return messages_.empty() ? zero() : time_of(messages_.front());
  }

private:
  using Place = typename std::deque<MConstPtr>::const_iterator;

  static rclcpp::Time zero() {return rclcpp::Time(0, 0, RCL_ROS_TIME);}
  static rclcpp::Time time_of(const MConstPtr & message)
  {
    return message_traits::TimeStamp<M>::value(*message);
  }
  static std::int64_t number(const MConstPtr & message) {return time_of(message).nanoseconds();}
  Place first_from(const rclcpp::Time & time) const
  {
    return std::find_if(
      messages_.begin(), messages_.end(), [&](const MConstPtr & each) {
        return number(each) >= time.nanoseconds();
      });
  }
  Place first_after(const rclcpp::Time & time) const
  {
    return std::find_if(
      messages_.begin(), messages_.end(), [&](const MConstPtr & each) {
        return number(each) > time.nanoseconds();
      });
  }

  mutable std::mutex mutex_;
  std::deque<MConstPtr> messages_;
  std::size_t size_ = 1;
  Connection connection_;
};

}  // namespace message_filters
