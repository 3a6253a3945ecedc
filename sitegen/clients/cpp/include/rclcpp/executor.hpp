#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <vector>

#include "rclcpp/any_executable.hpp"
#include "rclcpp/callback_group.hpp"
#include "rclcpp/executor_options.hpp"
#include "rclcpp/future_return_code.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"

namespace rclcpp
{

/// Waits until entities of its nodes are ready and runs their callbacks: timers first, then one message of
/// each subscription, one request of each service and one response of each client.
class Executor
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(Executor)
  RCLCPP_DISABLE_COPY(Executor)

  using NodeBase = node_interfaces::NodeBaseInterface::SharedPtr;

  explicit Executor(const ExecutorOptions & options = ExecutorOptions());
  virtual ~Executor();

  /// Throws std::runtime_error if the node is in an executor already.
  virtual void add_node(NodeBase node, bool notify = true);
  /// Throws std::runtime_error if the node is not in this executor.
  virtual void remove_node(NodeBase node, bool notify = true);
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

  virtual void add_callback_group(
    CallbackGroup::SharedPtr group, NodeBase node, bool notify = true);
  virtual void remove_callback_group(CallbackGroup::SharedPtr group, bool notify = true);
  virtual std::vector<CallbackGroup::WeakPtr> get_all_callback_groups();
  virtual std::vector<CallbackGroup::WeakPtr> get_manually_added_callback_groups();
  virtual std::vector<CallbackGroup::WeakPtr> get_automatically_added_callback_groups_from_nodes();

  virtual void spin();
  /// Run the callbacks that are ready now, each once at most.
  virtual void spin_some(std::chrono::nanoseconds max_duration = std::chrono::nanoseconds(0));
  /// Run callbacks until none is ready.
  virtual void spin_all(std::chrono::nanoseconds max_duration);
  virtual void spin_once(std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  void spin_node_some(NodeBase node);
  void spin_node_all(NodeBase node, std::chrono::nanoseconds max_duration);
  template<class NodeT>
  void spin_node_some(std::shared_ptr<NodeT> node)
  {
    spin_node_some(node->get_node_base_interface());
  }
  template<class NodeT>
  void spin_node_all(std::shared_ptr<NodeT> node, std::chrono::nanoseconds max_duration)
  {
    spin_node_all(node->get_node_base_interface(), max_duration);
  }
  template<class NodeT, class Rep = std::int64_t, class Period = std::milli>
  void spin_node_once(
    std::shared_ptr<NodeT> node,
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    add_node(node, false);
    spin_once(std::chrono::duration_cast<std::chrono::nanoseconds>(timeout));
    remove_node(node, false);
  }
  void cancel();
  bool is_spinning() const {return spinning;}

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

protected:
  /// Throws std::runtime_error if it is already spinning; `name` is the function called.
  void begin_spinning(const char * name);
  void end_spinning();
  /// Run the next callback that is ready; false if there is none.
  bool execute_next();
  /// Suspend until something may be ready, up to `timeout` ms; without a limit if negative.
  void wait(double timeout);
  /// Run callbacks and wait until canceled or shut down.
  void work();

  virtual void spin_once_impl(std::chrono::nanoseconds timeout);
  /// For executors of users: get the next entity that is ready, and wait for one if needed. Its callback
  /// group is busy until `any_executable` is destroyed.
  bool get_next_executable(
    AnyExecutable & any_executable,
    std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  bool get_next_ready_executable(AnyExecutable & any_executable);
  void wait_for_work(std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  void execute_any_executable(AnyExecutable & any_executable);
  static void execute_subscription(std::shared_ptr<SubscriptionBase> subscription);
  static void execute_timer(
    std::shared_ptr<TimerBase> timer, const std::shared_ptr<void> & data = nullptr);
  static void execute_service(std::shared_ptr<ServiceBase> service);
  static void execute_client(std::shared_ptr<ClientBase> client);

  std::atomic_bool spinning{false};
  Context::SharedPtr context_;

private:
  struct Candidate
  {
    detail::ExecutableKind kind;
    std::weak_ptr<CallbackGroup> group;
    std::weak_ptr<detail::Executable> executable;
  };

  bool may_go_on() const;
  /// `timeout` in ms, negative for none.
  FutureReturnCode spin_until(const std::function<bool()> & done, double timeout);
  std::vector<CallbackGroup::SharedPtr> groups();
  std::deque<Candidate> candidates();
  bool execute(const Candidate & candidate);
  NodeBase node_of(const CallbackGroup::SharedPtr & group) const;

  std::vector<std::weak_ptr<node_interfaces::NodeBaseInterface>> nodes_;
  std::vector<std::weak_ptr<CallbackGroup>> groups_;  // those that were added by hand
  std::deque<Candidate> round_;                       // what is looked at before all is again
};

}  // namespace rclcpp
