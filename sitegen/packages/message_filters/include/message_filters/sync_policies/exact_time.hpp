#pragma once

#include <cstdint>

#include "message_filters/synchronizer.hpp"

namespace message_filters
{
namespace sync_policies
{

/// See detail::ExactMatcher.
template<typename ... Ms>
class ExactTime : public PolicyBase<Ms...>
{
public:
  explicit ExactTime(std::uint32_t queue_size)
  : matcher_(sizeof...(Ms), queue_size) {}

protected:
  template<std::size_t I, class EventT, class SignalT>
  void match(const EventT & event, SignalT & signal)
  {
    matcher_.add(
      I, this->template item<I>(event), [&](const detail::Match & match) {
        this->call(signal, match);
      });
  }

private:
  detail::ExactMatcher matcher_;
};

}  // namespace sync_policies
}  // namespace message_filters
