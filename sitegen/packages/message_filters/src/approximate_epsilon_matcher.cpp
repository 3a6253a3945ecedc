#include <algorithm>
#include <utility>

#include "message_filters/detail/matcher.hpp"

namespace message_filters
{
namespace detail
{

void ApproximateEpsilonMatcher::add(
  std::size_t topic, Item item, const std::function<void(const Match &)> & emit)
{
  queues_[topic].push_back(std::move(item));
  const auto waits = [](const std::deque<Item> & queue) {return !queue.empty();};
  while (std::all_of(queues_.begin(), queues_.end(), waits)) {
    std::int64_t oldest = INT64_MAX;
    for (const auto & queue : queues_) {oldest = std::min(oldest, queue.front().stamp);}
    const auto is_near = [&](const std::deque<Item> & queue) {
        return queue.front().stamp - oldest <= epsilon_;
      };
    Match match;
    if (std::all_of(queues_.begin(), queues_.end(), is_near)) {
      for (const auto & queue : queues_) {match.push_back(queue.front());}
      emit(match);
    }
    for (auto & queue : queues_) {
      if (is_near(queue)) {queue.pop_front();}
    }
  }
  if (queues_[topic].size() > size_) {queues_[topic].pop_front();}
}

}  // namespace detail
}  // namespace message_filters
