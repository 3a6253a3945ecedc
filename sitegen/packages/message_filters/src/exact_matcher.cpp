#include <algorithm>
#include <iterator>
#include <utility>

#include "message_filters/detail/matcher.hpp"

namespace message_filters
{
namespace detail
{

void ExactMatcher::add(
  std::size_t topic, Item item, const std::function<void(const Match &)> & emit,
  const std::function<void(const Match &)> & drop)
{
  const auto place = waiting_.try_emplace(item.stamp, topics_).first;
  place->second[topic] = std::move(item);
  const auto is_there = [](const Item & each) {return each.message != nullptr;};
  if (std::all_of(place->second.begin(), place->second.end(), is_there)) {
    emit(place->second);
    // Older sets will never be complete.
    drop_until(waiting_.erase(place), drop);
  }
  if (size_ > 0 && waiting_.size() > size_) {
    drop_until(std::next(waiting_.begin(), waiting_.size() - size_), drop);
  }
}

void ExactMatcher::drop_until(
  Waiting::iterator end, const std::function<void(const Match &)> & drop)
{
  for (auto each = waiting_.begin(); each != end; ++each) {drop(each->second);}
  waiting_.erase(waiting_.begin(), end);
}

}  // namespace detail
}  // namespace message_filters
