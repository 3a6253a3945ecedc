#pragma once

#include <cstdint>
#include <utility>

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
  // Not explicit: programs give a synchronizer only the size of its queue.
  ExactTime(std::uint32_t queue_size)  // NOLINT(runtime/explicit)
  : matcher_(sizeof...(Ms), queue_size) {}

  /// Called with the messages of each set that will never be complete; null for those absent.
  template<class C>
  Connection registerDropCallback(C callback) {return dropped_.add(std::move(callback));}
  template<class C, typename T>
  Connection registerDropCallback(C callback, T * object)
  {
    return dropped_.add(detail::bound(callback, object));
  }

protected:
  template<std::size_t I, class EventT, class SignalT>
  void match(const EventT & event, SignalT & signal)
  {
    matcher_.add(
      I, this->template item<I>(event),
      [&](const detail::Match & match) {this->call(signal, match);},
      [&](const detail::Match & incomplete) {this->call(dropped_, incomplete);});
  }

private:
  detail::ExactMatcher matcher_;
  typename PolicyBase<Ms...>::Signal dropped_;
};

}  // namespace sync_policies
}  // namespace message_filters
