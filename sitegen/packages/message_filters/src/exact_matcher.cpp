#include <algorithm>
#include <utility>

#include "message_filters/detail/matcher.hpp"

namespace message_filters
{
namespace detail
{

void ExactMatcher::add(
  std::size_t topic, Item item, const std::function<void(const Match &)> & emit)
{
  const auto place = waiting_.try_emplace(item.stamp, topics_).first;
  auto & items = place->second;
  items[topic] = std::move(item);
  if (std::all_of(items.begin(), items.end(), [](const auto & each) {return each.has_value();})) {
    Match match;
    for (auto & each : items) {match.push_back(std::move(*each));}
    // Older sets will never be complete.
    waiting_.erase(waiting_.begin(), std::next(place));
    emit(match);
  }
  while (size_ > 0 && waiting_.size() > size_) {waiting_.erase(waiting_.begin());}
}

}  // namespace detail
}  // namespace message_filters
