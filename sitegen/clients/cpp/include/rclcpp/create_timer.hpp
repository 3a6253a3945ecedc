#pragma once

#include <chrono>
#include <memory>
#include <utility>

#include "rclcpp/node.hpp"

namespace rclcpp
{

/// A timer on `clock`; `node` is a pointer to anything that has get_node_base_interface().
template<class NodeT, class CallbackT>
typename GenericTimer<CallbackT>::SharedPtr create_timer(
  NodeT node, Clock::SharedPtr clock, Duration period, CallbackT && callback,
  CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
{
  auto timer = std::make_shared<GenericTimer<CallbackT>>(
    std::move(clock), detail::timer_period(period.to_chrono<std::chrono::nanoseconds>()),
    detail::timer_callback(std::forward<CallbackT>(callback)), autostart);
  node->get_node_base_interface()->add(detail::ExecutableKind::kTimer, timer, group);
  return timer;
}

}  // namespace rclcpp
