#pragma once

#include <algorithm>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <utility>

#include "message_filters/message_traits.hpp"
#include "message_filters/simple_filter.hpp"
#include "rclcpp/node.hpp"

namespace message_filters
{

/// Delays messages by `delay`, and passes them on ordered by time.
template<class M>
class TimeSequencer : public SimpleFilter<M>
{
public:
  using MConstPtr = std::shared_ptr<M const>;
  using EventType = MessageEvent<M const>;

  template<class F>
  TimeSequencer(
    F & filter, rclcpp::Duration delay, rclcpp::Duration update_rate, std::uint32_t queue_size,
    rclcpp::Node::SharedPtr node)
  : TimeSequencer(delay, update_rate, queue_size, std::move(node))
  {
    connectInput(filter);
  }
  TimeSequencer(
    rclcpp::Duration delay, rclcpp::Duration update_rate, std::uint32_t queue_size,
    rclcpp::Node::SharedPtr node)
  : delay_(delay), size_(queue_size), node_(std::move(node))
  {
    timer_ = node_->create_wall_timer(
      update_rate.template to_chrono<std::chrono::nanoseconds>(), [this]() {dispatch();});
  }
  ~TimeSequencer()
  {
    timer_->cancel();
    connection_.disconnect();
  }

  template<class F>
  void connectInput(F & filter)
  {
    connection_.disconnect();
    connection_ = filter.registerCallback([this](const EventType & event) {add(event);});
  }
  void add(const MConstPtr & message) {add(EventType(message));}
  void add(const EventType & event)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::int64_t time = time_of(event);
    if (time < last_time_) {return;}  // those that came after it are gone
    const auto later = [&](const EventType & each) {return time_of(each) > time;};
    events_.insert(std::find_if(events_.begin(), events_.end(), later), event);
    if (size_ != 0 && events_.size() > size_) {events_.pop_front();}
  }

private:
  static std::int64_t time_of(const EventType & event)
  {
    return message_traits::TimeStamp<M>::value(*event.getConstMessage()).nanoseconds();
  }

  void dispatch()
  {
    std::list<EventType> due;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      const std::int64_t limit = node_->now().nanoseconds() - delay_.nanoseconds();
      const auto end = std::find_if(
        events_.begin(), events_.end(), [&](const EventType & each) {
          return time_of(each) > limit;
        });
      due.splice(due.begin(), events_, events_.begin(), end);
      if (!due.empty()) {last_time_ = time_of(due.back());}
    }
    for (const EventType & event : due) {this->signalMessage(event);}
  }

  rclcpp::Duration delay_;
  std::size_t size_;
  rclcpp::Node::SharedPtr node_;
  rclcpp::TimerBase::SharedPtr timer_;
  Connection connection_;
  std::mutex mutex_;
  std::list<EventType> events_;
  std::int64_t last_time_ = 0;
};

}  // namespace message_filters
