#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <vector>

#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"

namespace rclcpp
{

enum class FutureReturnCode {SUCCESS, INTERRUPTED, TIMEOUT};

struct ExecutorOptions {};

/// Waits until something of its nodes is ready and calls back: timers first, then for one message of
/// each subscription, one request of each service and one response of each client.
class Executor
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(Executor)
  RCLCPP_DISABLE_COPY(Executor)

  using NodeBase = node_interfaces::NodeBaseInterface::SharedPtr;

  explicit Executor(const ExecutorOptions & = ExecutorOptions()) {}
  virtual ~Executor() = default;

  void add_node(NodeBase node, bool notify = true);
  void remove_node(NodeBase node, bool notify = true);
  template<class NodeT>
  void add_node(std::shared_ptr<NodeT> node, bool notify = true)
  {
    add_node(node->get_node_base_interface(), notify);
  }
  template<class NodeT>
  void remove_node(std::shared_ptr<NodeT> node, bool notify = true)
  {
    remove_node(node->get_node_base_interface(), notify);
  }

  virtual void spin();
  /// Call back for what is ready now, each thing once at most.
  virtual void spin_some(std::chrono::nanoseconds max_duration = std::chrono::nanoseconds(0));
  virtual void spin_all(std::chrono::nanoseconds max_duration);
  virtual void spin_once(std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  void cancel();

  template<class FutureT, class Rep = std::int64_t, class Period = std::milli>
  FutureReturnCode spin_until_future_complete(
    const FutureT & future,
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    const auto ready = [&future]() {
        return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
      };
    return spin_until(ready, std::chrono::duration<double, std::milli>(timeout).count());
  }

private:
  /// `timeout` in ms, negative for none.
  FutureReturnCode spin_until(const std::function<bool()> & done, double timeout);
  /// Call back for events, or for those of one endpoint only; false if there were none.
  bool execute_events(bool only_first);
  /// Run one round over what is ready, or only the first; false if nothing was.
  bool execute_ready(bool only_first);
  /// Suspend until something may be ready, `timeout` ms at most.
  void wait(double timeout);
  /// Let the event loop turn when it has not for a while: messages and Stop come by it.
  void breathe();

  std::vector<NodeBase> nodes_;
  bool canceled_ = false;
  double last_wait_ = 0;
  /// How many events there had been when all of them were handled.
  std::uint32_t events_ = 0;
};

}  // namespace rclcpp
