#pragma once

#include <chrono>
#include <memory>
#include <utility>

#include "rclcpp/node_interfaces/get_node_base_interface.hpp"
#include "rclcpp/node_interfaces/get_node_timers_interface.hpp"
#include "rclcpp/node_interfaces/node_parts.hpp"
#include "rclcpp/timer.hpp"

namespace rclcpp
{

/// A timer on `clock`; `node` is an object with get_node_base_interface(), or a pointer to one.
template<class NodeT, class CallbackT>
typename GenericTimer<CallbackT>::SharedPtr create_timer(
  NodeT && node, Clock::SharedPtr clock, Duration period, CallbackT && callback,
  CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
{
  auto timer = std::make_shared<GenericTimer<CallbackT>>(
    std::move(clock), detail::timer_period(period.to_chrono<std::chrono::nanoseconds>()),
    detail::timer_callback(std::forward<CallbackT>(callback)), autostart);
  node_interfaces::get_node_base_interface(node)->add(detail::ExecutableKind::kTimer, timer, group);
  return timer;
}

/// As upstream, for node interfaces.
template<class CallbackT>
typename GenericTimer<CallbackT>::SharedPtr create_timer(
  node_interfaces::NodeBaseInterface::SharedPtr base,
  node_interfaces::NodeTimersInterface::SharedPtr, Clock::SharedPtr clock, Duration period,
  CallbackT && callback, CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
{
  return create_timer(
    base, std::move(clock), period, std::forward<CallbackT>(callback), group, autostart);
}

template<class Rep, class Period, class CallbackT>
typename WallTimer<CallbackT>::SharedPtr create_wall_timer(
  std::chrono::duration<Rep, Period> period, CallbackT callback, CallbackGroup::SharedPtr group,
  node_interfaces::NodeBaseInterface * base, node_interfaces::NodeTimersInterface *,
  bool autostart = true)
{
  auto timer = std::make_shared<WallTimer<CallbackT>>(
    detail::timer_period(period), detail::timer_callback(std::move(callback)), autostart);
  base->add(detail::ExecutableKind::kTimer, timer, group);
  return timer;
}

}  // namespace rclcpp
