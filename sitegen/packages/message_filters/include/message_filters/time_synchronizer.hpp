#pragma once

#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

#include "message_filters/sync_policies/exact_time.hpp"
#include "message_filters/synchronizer.hpp"

namespace message_filters
{

/// Matches messages with exactly the same time.
template<class ... Ms>
class TimeSynchronizer : public Synchronizer<sync_policies::ExactTime<Ms...>>
{
public:
  using Policy = sync_policies::ExactTime<Ms...>;
  using Base = Synchronizer<Policy>;

  explicit TimeSynchronizer(std::uint32_t queue_size)
  : Base(Policy(queue_size)) {}
  /// Takes a filter for each message, then the size of the queue.
  template<class ... Args, std::enable_if_t<sizeof...(Args) == sizeof...(Ms) + 1, int> = 0>
  explicit TimeSynchronizer(Args && ... args)
  : TimeSynchronizer(static_cast<std::uint32_t>(std::get<sizeof...(Ms)>(std::tie(args ...))))
  {
    connect(std::index_sequence_for<Ms...>(), std::tie(args ...));
  }

private:
  template<std::size_t ... Is, class Tuple>
  void connect(std::index_sequence<Is...>, const Tuple & filters)
  {
    this->connectInput(std::get<Is>(filters)...);
  }
};

}  // namespace message_filters
