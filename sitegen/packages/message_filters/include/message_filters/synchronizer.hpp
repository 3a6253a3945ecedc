#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include "message_filters/connection.hpp"
#include "message_filters/detail/matcher.hpp"
#include "message_filters/detail/signal.hpp"
#include "message_filters/message_event.hpp"
#include "message_filters/message_traits.hpp"

namespace message_filters
{

/// The types of the messages that a policy matches, and the callbacks for matches.
template<typename ... Ms>
class PolicyBase
{
public:
  static constexpr std::size_t N_MESSAGES = sizeof...(Ms);
  using RealTypeCount = std::integral_constant<int, N_MESSAGES>;
  using Messages = std::tuple<Ms...>;
  using Events = std::tuple<MessageEvent<Ms const>...>;
  using Signal = detail::Signal<Ms...>;

protected:
  template<std::size_t I>
  static detail::Item item(const std::tuple_element_t<I, Events> & event)
  {
    using M = std::tuple_element_t<I, Messages>;
    const auto stamp = message_traits::TimeStamp<M>::value(*event.getConstMessage());
    return {event.getConstMessage(), event.getReceiptTime(), stamp.nanoseconds()};
  }
  static void call(Signal & signal, const detail::Match & match)
  {
    call(signal, match, std::index_sequence_for<Ms...>());
  }

private:
  template<std::size_t ... Is>
  static void call(Signal & signal, const detail::Match & match, std::index_sequence<Is...>)
  {
    signal.call(
      MessageEvent<Ms const>(
        std::static_pointer_cast<Ms const>(match[Is].message), match[Is].receipt)...);
  }
};

/// Matches the messages of several filters according to its policy, and runs callbacks for matches.
template<class Policy>
class Synchronizer : public Policy
{
public:
  using Messages = typename Policy::Messages;
  using Events = typename Policy::Events;
  using Signal = typename Policy::Signal;

  Synchronizer() = default;
  Synchronizer(const Policy & policy)  // NOLINT(runtime/explicit)
  : Policy(policy) {}
  template<class ... Fs, std::enable_if_t<sizeof...(Fs) == Policy::N_MESSAGES, int> = 0>
  Synchronizer(const Policy & policy, Fs & ... filters)
  : Policy(policy)
  {
    connectInput(filters ...);
  }
  template<class ... Fs, std::enable_if_t<sizeof...(Fs) == Policy::N_MESSAGES, int> = 0>
  Synchronizer(Fs & ... filters) {connectInput(filters ...);}
  Synchronizer(const Synchronizer &) = delete;
  Synchronizer & operator=(const Synchronizer &) = delete;
  ~Synchronizer() {disconnectAll();}

  template<class ... Fs>
  void connectInput(Fs & ... filters)
  {
    static_assert(
      sizeof...(Fs) == Policy::N_MESSAGES, "a synchronizer has as many inputs as messages");
    disconnectAll();
    connect(std::index_sequence_for<Fs...>(), filters ...);
  }
  void disconnectAll()
  {
    for (Connection & each : connections_) {each.disconnect();}
  }

  template<class C>
  Connection registerCallback(C callback) {return signal_.add(std::move(callback));}
  template<class C, typename T>
  Connection registerCallback(C callback, T * object)
  {
    return signal_.add(detail::bound(callback, object));
  }

  template<std::size_t I>
  void add(const std::shared_ptr<std::tuple_element_t<I, Messages> const> & message)
  {
    add<I>(std::tuple_element_t<I, Events>(message));
  }
  template<std::size_t I>
  void add(const std::tuple_element_t<I, Events> & event)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    this->template match<I>(event, signal_);
  }

  /// Runs the callbacks.
  template<class ... Es>
  void signal(const Es & ... events) {signal_.call(events ...);}

  Policy * getPolicy() {return this;}
  void setName(const std::string & name) {name_ = name;}
  const std::string & getName() const {return name_;}

private:
  template<std::size_t ... Is, class ... Fs>
  void connect(std::index_sequence<Is...>, Fs & ... filters)
  {
    ((connections_[Is] = filters.registerCallback(
      [this](const std::tuple_element_t<Is, Events> & event) {this->template add<Is>(event);})),
    ...);
  }

  Signal signal_;
  std::mutex mutex_;
  std::array<Connection, Policy::N_MESSAGES> connections_;
  std::string name_;
};

}  // namespace message_filters
