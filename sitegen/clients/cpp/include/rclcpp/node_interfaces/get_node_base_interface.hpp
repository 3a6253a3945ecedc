#pragma once

#include <memory>
#include <type_traits>

#include "rclcpp/detail/pointed_at.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"

namespace rclcpp
{
namespace node_interfaces
{

/// `node` is an object with get_node_base_interface(), a pointer to one, or the interface itself.
template<class NodeT>
std::shared_ptr<NodeBaseInterface> get_node_base_interface(NodeT && node)
{
  if constexpr (std::is_convertible_v<NodeT, std::shared_ptr<NodeBaseInterface>>) {
    return node;
  } else {
    return rclcpp::detail::pointed_at(node).get_node_base_interface();
  }
}

}  // namespace node_interfaces
}  // namespace rclcpp
