// Matches the messages of several topics by time; their types do not matter.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "rclcpp/clock.hpp"
#include "rclcpp/duration.hpp"
#include "rclcpp/time.hpp"

namespace message_filters
{
namespace detail
{

/// A message; `stamp` is its time in nanoseconds.
struct Item
{
  std::shared_ptr<const void> message;
  rclcpp::Time receipt;
  std::int64_t stamp = 0;
};

/// One message of each topic.
using Match = std::vector<Item>;

/// Matches messages of all topics with equal times.
class ExactMatcher
{
public:
  ExactMatcher(std::size_t topics, std::uint32_t queue_size)
  : topics_(topics), size_(queue_size) {}

  /// `drop` is called with each set that will never be complete; absent messages are null.
  void add(
    std::size_t topic, Item item, const std::function<void(const Match &)> & emit,
    const std::function<void(const Match &)> & drop);

private:
  using Waiting = std::map<std::int64_t, Match>;

  void drop_until(Waiting::iterator end, const std::function<void(const Match &)> & drop);

  std::size_t topics_;
  std::size_t size_;
  Waiting waiting_;  // by their time
};

/// Matches the oldest messages of all topics if their times differ by at most `epsilon`.
class ApproximateEpsilonMatcher
{
public:
  ApproximateEpsilonMatcher(
    std::size_t topics, std::uint32_t queue_size, rclcpp::Duration epsilon)
  : queues_(topics), size_(queue_size), epsilon_(epsilon.nanoseconds()) {}

  void add(std::size_t topic, Item item, const std::function<void(const Match &)> & emit);

private:
  std::vector<std::deque<Item>> queues_;
  std::size_t size_;
  std::int64_t epsilon_;
};

/// Matches the newest messages of all topics whenever the fastest topic has a message; messages of
/// slower topics are repeated. Rates are measured with `clock`.
class LatestMatcher
{
public:
  /// The weight of a new period for the rate of a topic, its weight for the error of the rate, and
  /// the multiple of the error above which the rate is considered to have changed.
  struct Weights
  {
    double rate = 0.9;
    double error = 0.3;
    double margin = 10.0;
  };

  LatestMatcher(std::size_t topics, rclcpp::Clock::SharedPtr clock)
  : topics_(topics), clock_(std::move(clock)) {}

  void add(std::size_t topic, Item item, const std::function<void(const Match &)> & emit);

  void set_clock(rclcpp::Clock::SharedPtr clock) {clock_ = std::move(clock);}
  /// One value for all topics, or one for each.
  void set_weights(std::vector<Weights> weights) {weights_ = std::move(weights);}

private:
  struct Topic
  {
    std::optional<Item> latest;
    Weights weights;
    std::int64_t last = 0;           // when it came, in nanoseconds
    double rate = 0;                 // of messages in a second, 0 while it is not known
    std::optional<double> error;     // how far periods are off that, in the same unit
  };

  bool measure(Topic & topic, std::int64_t now) const;
  std::optional<std::size_t> fastest(std::int64_t now) const;

  std::vector<Topic> topics_;
  rclcpp::Clock::SharedPtr clock_;
  std::vector<Weights> weights_;
};

/// Matches messages whose times are closest to each other; no message is in two matches, and
/// matches do not cross. A candidate has one message of each topic. The pivot is the topic with the
/// latest message of the first candidate: all following candidates contain that message, so the
/// search ends.
class ApproximateMatcher
{
public:
  ApproximateMatcher(std::size_t topics, std::uint32_t queue_size);

  void add(std::size_t topic, Item item, const std::function<void(const Match &)> & emit);

  /// The penalty for later candidates, 0.1 by default.
  void setAgePenalty(double age_penalty) {age_penalty_ = age_penalty;}
  /// The minimum time between messages of topic `i`, with which matches are found earlier.
  void setInterMessageLowerBound(int i, rclcpp::Duration lower_bound)
  {
    topics_[i].lower_bound = lower_bound.nanoseconds();
  }
  /// The maximum difference of times in a match.
  void setMaxIntervalDuration(rclcpp::Duration max_interval_duration)
  {
    max_interval_ = max_interval_duration.nanoseconds();
  }

private:
  struct Topic
  {
    std::deque<Item> waiting;
    std::vector<Item> past;  // those that the search has gone past, and may come back to
    bool dropped = false;
    bool warned = false;
    std::int64_t lower_bound = 0;
  };

  /// The earliest and the latest time of the topics' current messages, and the topics at these
  /// times.
  struct Interval
  {
    std::size_t first;
    std::size_t last;
    std::int64_t start;
    std::int64_t end;
  };

  bool all_wait() const;
  /// If no message waits, the earliest time that the next one can have.
  std::int64_t time_at(const Topic & topic) const;
  Interval interval() const;
  bool is_better(const Interval & next) const;
  bool is_best(const Interval & next) const;
  void check_bound(std::size_t index);
  void search(const std::function<void(const Match &)> & emit);
  void take(const Interval & at);
  void go_past(std::size_t index);
  void come_back(std::size_t index, std::size_t count);
  bool no_other_can_be_better();
  void publish(const std::function<void(const Match &)> & emit);

  std::vector<Topic> topics_;
  std::size_t size_;
  double age_penalty_ = 0.1;
  std::int64_t max_interval_ = INT64_MAX;
  Match candidate_;
  std::int64_t candidate_start_ = 0;
  std::int64_t candidate_end_ = 0;
  std::optional<std::size_t> pivot_;
  std::int64_t pivot_time_ = 0;
};

}  // namespace detail
}  // namespace message_filters
