#include <algorithm>
#include <utility>

#include "message_filters/detail/matcher.hpp"
#include "rclcpp/logging.hpp"

namespace message_filters
{
namespace detail
{

ApproximateMatcher::ApproximateMatcher(std::size_t topics, std::uint32_t queue_size)
: topics_(topics), size_(queue_size) {}

void ApproximateMatcher::add(
  std::size_t topic, Item item, const std::function<void(const Match &)> & emit)
{
  Topic & its = topics_[topic];
  its.waiting.push_back(std::move(item));
  if (its.waiting.size() > 1) {
    check_bound(topic);
  } else if (all_wait()) {
    search(emit);
  }
  if (its.waiting.size() + its.past.size() <= size_) {return;}
  for (std::size_t i = 0; i < topics_.size(); ++i) {come_back(i, topics_[i].past.size());}
  its.waiting.pop_front();
  its.dropped = true;
  if (pivot_) {
    candidate_.clear();
    pivot_.reset();
    search(emit);
  }
}

bool ApproximateMatcher::all_wait() const
{
  return std::all_of(
    topics_.begin(), topics_.end(), [](const Topic & each) {return !each.waiting.empty();});
}

std::int64_t ApproximateMatcher::time_at(const Topic & topic) const
{
  if (!topic.waiting.empty()) {return topic.waiting.front().stamp;}
  return std::max(topic.past.back().stamp + topic.lower_bound, pivot_time_);
}

ApproximateMatcher::Interval ApproximateMatcher::interval() const
{
  Interval found{0, 0, INT64_MAX, INT64_MIN};
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    const std::int64_t time = time_at(topics_[i]);
    if (time < found.start) {
      found.first = i;
      found.start = time;
    }
    if (time >= found.end) {
      found.last = i;
      found.end = time;
    }
  }
  return found;
}

/// Whether `next` is smaller than the candidate, with the penalty for being later.
bool ApproximateMatcher::is_better(const Interval & next) const
{
  const double later = static_cast<double>(next.end - candidate_end_) * (1 + age_penalty_);
  return later < static_cast<double>(next.start - candidate_start_);
}

/// Whether no interval that begins after `next` and contains the pivot can be better.
bool ApproximateMatcher::is_best(const Interval & next) const
{
  const double later = static_cast<double>(next.end - candidate_end_) * (1 + age_penalty_);
  return later >= static_cast<double>(pivot_time_ - candidate_start_);
}

void ApproximateMatcher::check_bound(std::size_t index)
{
  Topic & topic = topics_[index];
  if (topic.warned) {return;}
  const std::int64_t gap = topic.waiting.back().stamp - std::prev(topic.waiting.end(), 2)->stamp;
  if (gap >= 0 && gap >= topic.lower_bound) {return;}
  topic.warned = true;
  if (gap < 0) {
    RCLCPP_WARN(
      rclcpp::get_logger(""), "Messages of type %zu arrived out of order (will print only once)",
      index);
  } else {
    RCLCPP_WARN(
      rclcpp::get_logger(""), "Messages of type %zu arrived closer (%ld) than the lower bound you "
      "provided (%ld) (will print only once)", index, gap, topic.lower_bound);
  }
}

void ApproximateMatcher::search(const std::function<void(const Match &)> & emit)
{
  while (all_wait()) {
    const Interval at = interval();
    for (std::size_t i = 0; i < topics_.size(); ++i) {
      if (i != at.last) {topics_[i].dropped = false;}
    }
    if (!pivot_) {
      // A dropped message might have been a better match than the pivot.
      if (at.end - at.start > max_interval_ || topics_[at.last].dropped) {
        topics_[at.first].waiting.pop_front();
        continue;
      }
      take(at);
      pivot_ = at.last;
      pivot_time_ = at.end;
    } else if (is_better(at)) {
      take(at);
    }
    go_past(at.first);
    if (at.first == *pivot_ || is_best(at) || (!all_wait() && no_other_can_be_better())) {
      publish(emit);
    }
  }
}

void ApproximateMatcher::take(const Interval & at)
{
  candidate_.clear();
  for (Topic & topic : topics_) {
    candidate_.push_back(topic.waiting.front());
    topic.past.clear();
  }
  candidate_start_ = at.start;
  candidate_end_ = at.end;
}

void ApproximateMatcher::go_past(std::size_t index)
{
  Topic & topic = topics_[index];
  topic.past.push_back(std::move(topic.waiting.front()));
  topic.waiting.pop_front();
}

void ApproximateMatcher::come_back(std::size_t index, std::size_t count)
{
  Topic & topic = topics_[index];
  for (; count > 0; --count) {
    topic.waiting.push_front(std::move(topic.past.back()));
    topic.past.pop_back();
  }
}

/// Continue with the earliest possible messages, and check whether they could be better.
bool ApproximateMatcher::no_other_can_be_better()
{
  std::vector<std::size_t> moves(topics_.size());
  bool best = false;
  for (;; ) {
    const Interval at = interval();
    best = is_best(at);
    if (best || is_better(at)) {break;}
    // The search has not reached the pivot, so this topic has another message.
    go_past(at.first);
    ++moves[at.first];
  }
  if (!best) {
    for (std::size_t i = 0; i < topics_.size(); ++i) {come_back(i, moves[i]);}
  }
  return best;
}

void ApproximateMatcher::publish(const std::function<void(const Match &)> & emit)
{
  emit(std::exchange(candidate_, {}));
  pivot_.reset();
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    come_back(i, topics_[i].past.size());
    topics_[i].waiting.pop_front();
  }
}

}  // namespace detail
}  // namespace message_filters
