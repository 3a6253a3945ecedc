#pragma once

#include <memory>
#include <type_traits>

#include "rclcpp/detail/pointed_at.hpp"
#include "rclcpp/node_interfaces/node_parts.hpp"

namespace rclcpp
{
namespace node_interfaces
{

/// `node` is an object with get_node_timers_interface(), a pointer to one, or the interface itself.
template<class NodeT>
std::shared_ptr<NodeTimersInterface> get_node_timers_interface(NodeT && node)
{
  if constexpr (std::is_convertible_v<NodeT, std::shared_ptr<NodeTimersInterface>>) {
    return node;
  } else {
    return rclcpp::detail::pointed_at(node).get_node_timers_interface();
  }
}

}  // namespace node_interfaces
}  // namespace rclcpp
