#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <tuple>
#include <utility>

#include "message_filters/connection.hpp"
#include "message_filters/detail/signal.hpp"
#include "message_filters/message_event.hpp"
#include "message_filters/message_traits.hpp"
#include "rclcpp/duration.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/timer.hpp"

namespace message_filters
{

/// Passes on the messages of several inputs, each to its own output, ordered by time. It waits
/// until all inputs have reached a time, but at most `timeout` for a silent input.
template<typename ... Ms>
class InputAligner
{
public:
  static constexpr std::size_t N_INPUTS = sizeof...(Ms);
  using Messages = std::tuple<Ms...>;
  using Events = std::tuple<MessageEvent<Ms const>...>;

  struct QueueStatus
  {
    bool active;
    std::size_t queue_size;
    std::size_t msgs_processed;
    std::size_t msgs_dropped;
  };

  explicit InputAligner(const rclcpp::Duration & timeout)
  : timeout_(timeout.nanoseconds()) {}
  template<class F0, class F1, class ... Fs>
  InputAligner(const rclcpp::Duration & timeout, F0 & f0, F1 & f1, Fs & ... filters)
  : InputAligner(timeout)
  {
    connectInput(f0, f1, filters ...);
  }
  InputAligner(const InputAligner &) = delete;
  InputAligner & operator=(const InputAligner &) = delete;
  virtual ~InputAligner() {disconnectAll();}

  template<class ... Fs>
  void connectInput(Fs & ... filters)
  {
    static_assert(sizeof...(Fs) <= N_INPUTS, "an aligner has as many inputs as messages");
    disconnectAll();
    connect(std::index_sequence_for<Fs...>(), filters ...);
  }

  template<std::size_t I, class C>
  Connection registerCallback(C callback)
  {
    return std::get<I>(signals_).add(std::move(callback));
  }
  template<std::size_t I, class C, typename T>
  Connection registerCallback(C callback, T * object)
  {
    return std::get<I>(signals_).add(detail::bound(callback, object));
  }

  template<std::size_t I>
  void add(const std::shared_ptr<std::tuple_element_t<I, Messages> const> & message)
  {
    add<I>(std::tuple_element_t<I, Events>(message));
  }

  /// The minimum time between messages of input `I`: the next message is known to be later.
  template<std::size_t I>
  void setInputPeriod(const rclcpp::Duration & period)
  {
    inputs_[I].period = period.nanoseconds();
  }
  template<std::size_t I>
  QueueStatus getQueueStatus() const
  {
    const Input & input = inputs_[I];
    return {input.active, std::get<I>(queues_).size(), input.processed, input.dropped};
  }

  void setName(const std::string & name) {name_ = name;}
  const std::string & getName() const {return name_;}

  template<class NodeT>
  void setupDispatchTimer(std::shared_ptr<NodeT> node, const rclcpp::Duration & update_rate)
  {
    timer_ = node->create_wall_timer(
      std::chrono::nanoseconds(update_rate.nanoseconds()), [this]() {dispatchMessages();});
  }

  /// Pass on all messages that are due; can be called by a timer.
  void dispatchMessages()
  {
    const auto all = std::index_sequence_for<Ms...>();
    const std::lock_guard<std::mutex> lock(mutex_);
    if (any_waits(all)) {
      while (dispatch_first(all)) {}
    }
  }

private:
  template<class M>
  using Queue = std::multimap<std::int64_t, MessageEvent<M const>>;

  struct Input
  {
    std::int64_t period = 0;  // ns, as all times here
    std::int64_t next = INT64_MAX;
    bool active = false;
    std::size_t processed = 0;
    std::size_t dropped = 0;
  };

  template<std::size_t ... Is, class ... Fs>
  void connect(std::index_sequence<Is...>, Fs & ... filters)
  {
    ((connections_[Is] = filters.registerCallback(
      [this](const std::tuple_element_t<Is, Events> & event) {this->template add<Is>(event);})),
    ...);
  }
  void disconnectAll()
  {
    for (Connection & each : connections_) {each.disconnect();}
  }

  template<std::size_t I>
  void add(const std::tuple_element_t<I, Events> & event)
  {
    using M = std::tuple_element_t<I, Messages>;
    const std::int64_t time =
      message_traits::TimeStamp<M>::value(*event.getConstMessage()).nanoseconds();
    const std::lock_guard<std::mutex> lock(mutex_);
    if (time < passed_) {
      ++inputs_[I].dropped;
      RCLCPP_WARN(
        rclcpp::get_logger("message_filters"),
        "Messages of type %zu arrived too late and will be dropped", I);
      return;
    }
    newest_ = std::max(newest_, time);
    std::get<I>(queues_).emplace(time, event);
  }

  template<std::size_t ... Is>
  bool any_waits(std::index_sequence<Is...>) const
  {
    return (!std::get<Is>(queues_).empty() || ...);
  }

  /// The current time of input `I`: that of its waiting message, or of the next possible one.
  template<std::size_t I>
  std::int64_t time_at()
  {
    Input & input = inputs_[I];
    const auto & queue = std::get<I>(queues_);
    if (queue.empty()) {return input.active ? input.next : INT64_MAX;}
    input.active = true;
    input.next = queue.begin()->first + input.period;
    return queue.begin()->first;
  }

  /// Pass on the earliest message, or stop waiting for a silent input; false if there is nothing to
  /// do.
  template<std::size_t ... Is>
  bool dispatch_first(std::index_sequence<Is...>)
  {
    const std::array<std::int64_t, N_INPUTS> times = {time_at<Is>()...};
    const auto first = static_cast<std::size_t>(
      std::min_element(times.begin(), times.end()) - times.begin());
    return ((Is == first && dispatch<Is>(times[Is])) || ...);
  }
  template<std::size_t I>
  bool dispatch(std::int64_t time)
  {
    auto & queue = std::get<I>(queues_);
    Input & input = inputs_[I];
    if (queue.empty()) {
      if (newest_ - time < timeout_) {return false;}
      input.active = false;
      return true;
    }
    const auto event = queue.begin()->second;
    queue.erase(queue.begin());
    ++input.processed;
    passed_ = time;
    std::get<I>(signals_).call(event);
    return true;
  }

  std::int64_t timeout_;
  std::int64_t newest_ = 0;
  std::int64_t passed_ = 0;
  std::array<Input, N_INPUTS> inputs_;
  std::tuple<Queue<Ms>...> queues_;
  std::tuple<detail::Signal<Ms>...> signals_;
  std::array<Connection, N_INPUTS> connections_;
  std::mutex mutex_;
  std::string name_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace message_filters
