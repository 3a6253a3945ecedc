// What free functions take for a node: anything that has get_node_base_interface(), or a pointer to it.
#pragma once

#include <type_traits>

#include "rclcpp/node_interfaces/node_base_interface.hpp"

namespace rclcpp
{
namespace detail
{

template<class T, class = void>
struct IsNode : std::false_type {};
template<class T>
struct IsNode<T, std::void_t<decltype(std::declval<T &>().get_node_base_interface())>>
  : std::true_type {};

template<class NodeT>
node_interfaces::NodeBaseInterface::SharedPtr base_of(NodeT && node)
{
  if constexpr (IsNode<std::remove_reference_t<NodeT>>::value) {
    return node.get_node_base_interface();
  } else {
    return node->get_node_base_interface();
  }
}

}  // namespace detail
}  // namespace rclcpp
