// Callbacks with one message of each type, in any form that programs use.
#pragma once

#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <type_traits>
#include <utility>
#include <vector>

#include "message_filters/connection.hpp"
#include "message_filters/message_event.hpp"

namespace message_filters
{
namespace detail
{

/// Converts to the type of a callback's parameter.
template<class M>
class Argument
{
public:
  explicit Argument(const MessageEvent<const M> & event)
  : event_(event) {}

  operator std::shared_ptr<const M>() const {return event_.getConstMessage();}
  operator std::shared_ptr<M>() const
  {
    const auto message = event_.getConstMessage();
    return message ? std::make_shared<M>(*message) : nullptr;
  }
  operator const M &() const {return *event_.getConstMessage();}
  operator const MessageEvent<const M> &() const {return event_;}
  operator MessageEvent<M>() const {return event_;}

private:
  const MessageEvent<const M> & event_;
};

template<class ... Ms>
class Signal
{
public:
  using Callback = std::function<void (const MessageEvent<const Ms> & ...)>;

  template<class C>
  Connection add(C callback)
  {
    if constexpr (std::is_invocable_v<C &, const std::shared_ptr<const Ms> & ...>) {
      return keep(
        [callback = std::move(callback)](const MessageEvent<const Ms> & ... events) mutable {
          callback(events.getConstMessage()...);
        });
    } else {
      static_assert(
        std::is_invocable_v<C &, Argument<Ms>...>,
        "a filter's callback takes, for each message, `const std::shared_ptr<const M> &`, "
        "`const M &` or `const MessageEvent<const M> &`");
      return keep(
        [callback = std::move(callback)](const MessageEvent<const Ms> & ... events) mutable {
          callback(Argument<Ms>(events)...);
        });
    }
  }

  void call(const MessageEvent<const Ms> & ... events)
  {
    std::vector<std::shared_ptr<Callback>> callbacks;
    {
      const std::lock_guard<std::mutex> lock(kept_->mutex);
      callbacks.assign(kept_->callbacks.begin(), kept_->callbacks.end());
    }
    for (const auto & callback : callbacks) {(*callback)(events ...);}
  }

private:
  struct Kept
  {
    std::mutex mutex;
    std::list<std::shared_ptr<Callback>> callbacks;
  };

  Connection keep(Callback callback)
  {
    auto one = std::make_shared<Callback>(std::move(callback));
    const std::lock_guard<std::mutex> lock(kept_->mutex);
    kept_->callbacks.push_back(one);
    return Connection(
      [weak = std::weak_ptr<Kept>(kept_), one]() {
        if (auto kept = weak.lock()) {
          const std::lock_guard<std::mutex> inner(kept->mutex);
          kept->callbacks.remove(one);
        }
      });
  }

  std::shared_ptr<Kept> kept_ = std::make_shared<Kept>();
};

/// A member function of `object`, as a callback.
template<class T, class U, class R, class ... Ps>
auto bound(R (T::* member)(Ps...), U * object)
{
  return [member, object](Ps... values) {(object->*member)(values ...);};
}

template<class T, class U, class R, class ... Ps>
auto bound(R (T::* member)(Ps...) const, U * object)
{
  return [member, object](Ps... values) {(object->*member)(values ...);};
}

/// A function with its first arguments bound.
template<class R, class T, class U, class ... Ps>
auto bound(R (* function)(T, Ps...), U * object)
{
  return [function, object](Ps... values) {function(object, values ...);};
}

}  // namespace detail
}  // namespace message_filters
