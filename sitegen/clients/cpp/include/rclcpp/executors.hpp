#pragma once

#include <chrono>
#include <memory>

#include "rclcpp/executors/single_threaded_executor.hpp"
#include "rclcpp/node.hpp"

namespace rclcpp
{

void spin(node_interfaces::NodeBaseInterface::SharedPtr node);
void spin(Node::SharedPtr node);
void spin_some(node_interfaces::NodeBaseInterface::SharedPtr node);
void spin_some(Node::SharedPtr node);

template<class NodeT, class FutureT, class Rep = std::int64_t, class Period = std::milli>
FutureReturnCode spin_until_future_complete(
  std::shared_ptr<NodeT> node, const FutureT & future,
  std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
{
  executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  return executor.spin_until_future_complete(future, timeout);
}

}  // namespace rclcpp
