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

  /// Takes the size of the queue, then a filter for each message or none.
  template<
    class ... Fs,
    std::enable_if_t<sizeof...(Fs) == 0 || sizeof...(Fs) == sizeof...(Ms), int> = 0>
  TimeSynchronizer(std::uint32_t queue_size, Fs & ... filters)  // NOLINT(runtime/explicit)
  : Base(Policy(queue_size))
  {
    if constexpr (sizeof...(Fs) != 0) {this->connectInput(filters ...);}
  }
  /// The same with the size of the queue at the end.
  template<
    class F, class ... Args,
    std::enable_if_t<
      sizeof...(Args) == sizeof...(Ms) && !std::is_convertible_v<F, std::uint32_t>, int> = 0>
  TimeSynchronizer(F & first, Args && ... args)
  : TimeSynchronizer(
      static_cast<std::uint32_t>(std::get<sizeof...(Ms)>(std::tie(first, args ...))))
  {
    connect(std::index_sequence_for<Ms...>(), std::tie(first, args ...));
  }

private:
  template<std::size_t ... Is, class Tuple>
  void connect(std::index_sequence<Is...>, const Tuple & filters)
  {
    this->connectInput(std::get<Is>(filters)...);
  }
};

}  // namespace message_filters
