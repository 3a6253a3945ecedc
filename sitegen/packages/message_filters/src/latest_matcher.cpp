#include <algorithm>
#include <cmath>
#include <utility>

#include "message_filters/detail/matcher.hpp"

namespace message_filters
{
namespace detail
{

void LatestMatcher::add(
  std::size_t index, Item item, const std::function<void(const Match &)> & emit)
{
  Topic & topic = topics_[index];
  const std::int64_t now = clock_->now().nanoseconds();
  const bool first = !topic.latest;
  topic.latest = std::move(item);
  if (first) {
    // The rate is known from the second message on.
    if (weights_.size() == topics_.size()) {
      topic.weights = weights_[index];
    } else if (weights_.size() == 1) {
      topic.weights = weights_.front();
    }
    topic.last = now;
    return;
  }
  if (!measure(topic, now) || fastest(now) != index) {return;}
  Match match;
  for (const Topic & each : topics_) {
    if (!each.latest) {return;}
    match.push_back(*each.latest);
  }
  emit(match);
}

/// Update the rate of `topic` with the time since its last message; false if no time has passed.
bool LatestMatcher::measure(Topic & topic, std::int64_t now) const
{
  const double period = static_cast<double>(now - topic.last) / 1e9;
  if (period <= 0) {return false;}
  topic.last = now;
  const double rate = 1 / period;
  const double off = std::abs(topic.rate - rate);
  const auto & weights = topic.weights;
  if (topic.rate <= 0 || (topic.error && off > weights.margin * *topic.error)) {
    topic.rate = rate;
    topic.error.reset();
    return true;
  }
  topic.error = topic.error ? weights.error * off + (1 - weights.error) * *topic.error : off;
  topic.rate = weights.rate * rate + (1 - weights.rate) * topic.rate;
  return true;
}

/// The topic with the highest rate among those that are not late.
std::optional<std::size_t> LatestMatcher::fastest(std::int64_t now) const
{
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    const Topic & topic = topics_[i];
    if (topic.rate <= 0 || (found && topic.rate <= topics_[*found].rate)) {continue;}
    const double waited = static_cast<double>(now - topic.last) / 1e9;
    const bool late = waited > 0 && topic.error &&
      topic.rate - 1 / waited > topic.weights.margin * *topic.error;
    if (!late) {found = i;}
  }
  return found;
}

}  // namespace detail
}  // namespace message_filters
