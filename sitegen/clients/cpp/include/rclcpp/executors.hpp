#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <utility>

#include "rclcpp/executors/multi_threaded_executor.hpp"
#include "rclcpp/executors/single_threaded_executor.hpp"
#include "rclcpp/executors/static_single_threaded_executor.hpp"
#include "rclcpp/node.hpp"

namespace rclcpp
{

using executors::MultiThreadedExecutor;
using executors::SingleThreadedExecutor;

void spin(node_interfaces::NodeBaseInterface::SharedPtr node);
void spin_some(node_interfaces::NodeBaseInterface::SharedPtr node);
void spin_all(
  node_interfaces::NodeBaseInterface::SharedPtr node, std::chrono::nanoseconds max_duration);

template<class NodeT>
void spin(std::shared_ptr<NodeT> node) {spin(node->get_node_base_interface());}
template<class NodeT>
void spin_some(std::shared_ptr<NodeT> node) {spin_some(node->get_node_base_interface());}
template<class NodeT>
void spin_all(std::shared_ptr<NodeT> node, std::chrono::nanoseconds max_duration)
{
  spin_all(node->get_node_base_interface(), max_duration);
}

/// As upstream, where a unique pointer becomes a shared one.
template<class NodeT>
void spin(std::unique_ptr<NodeT> node) {spin(std::shared_ptr<NodeT>(std::move(node)));}
template<class NodeT>
void spin_some(std::unique_ptr<NodeT> node) {spin_some(std::shared_ptr<NodeT>(std::move(node)));}

namespace executors
{

template<class NodeT, class FutureT, class Rep = std::int64_t, class Period = std::milli>
FutureReturnCode spin_node_until_future_complete(
  Executor & executor, std::shared_ptr<NodeT> node, const FutureT & future,
  std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
{
  executor.add_node(node);
  const auto code = executor.spin_until_future_complete(future, timeout);
  executor.remove_node(node);
  return code;
}

}  // namespace executors

template<class NodeT, class FutureT, class Rep = std::int64_t, class Period = std::milli>
FutureReturnCode spin_until_future_complete(
  std::shared_ptr<NodeT> node, const FutureT & future,
  std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
{
  executors::SingleThreadedExecutor executor;
  return executors::spin_node_until_future_complete(executor, node, future, timeout);
}

}  // namespace rclcpp
