// The requests of a client that have no response yet.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace rclcpp
{
namespace detail
{

template<class ResponseT>
class PendingRequests
{
public:
  using Complete = std::function<void (std::shared_ptr<ResponseT>)>;
  using TimePoint = std::chrono::time_point<std::chrono::system_clock>;

  void add(std::int64_t id, Complete complete)
  {
    pending_.emplace(id, Pending{std::chrono::system_clock::now(), std::move(complete)});
  }
  bool has(std::int64_t id) const {return pending_.count(id) != 0;}
  bool remove(std::int64_t id) {return pending_.erase(id) != 0;}
  /// Remove a request, which must be pending, and return its callback.
  Complete take(std::int64_t id) {return std::move(pending_.extract(id).mapped().complete);}

  /// Remove requests sent before `time_point`, and add their ids to `removed`.
  template<class AllocatorT>
  std::size_t remove_older_than(TimePoint time_point, std::vector<std::int64_t, AllocatorT> * removed)
  {
    const std::size_t before = pending_.size();
    for (auto one = pending_.begin(); one != pending_.end(); ) {
      if (one->second.sent >= time_point) {
        ++one;
        continue;
      }
      if (removed) {removed->push_back(one->first);}
      one = pending_.erase(one);
    }
    return before - pending_.size();
  }
  std::size_t clear() {return std::exchange(pending_, {}).size();}

private:
  struct Pending
  {
    TimePoint sent;
    Complete complete;
  };

  std::map<std::int64_t, Pending> pending_;
};

}  // namespace detail
}  // namespace rclcpp
