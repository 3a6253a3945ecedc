#pragma once

#include <type_traits>
#include <utility>

#include "rclcpp/node_interfaces/node_base_interface.hpp"

namespace rclcpp
{
namespace detail
{

template<class T, class = void>
struct points : std::is_pointer<T> {};
template<class T>
struct points<T, std::void_t<decltype(std::declval<T &>().operator->())>> : std::true_type {};

}  // namespace detail

namespace node_interfaces
{

/// `node` is anything that has get_node_base_interface(), or a pointer to it.
template<class NodeT>
NodeBaseInterface::SharedPtr get_node_base_interface(NodeT && node)
{
  if constexpr (rclcpp::detail::points<std::decay_t<NodeT>>::value) {
    return node->get_node_base_interface();
  } else {
    return node.get_node_base_interface();
  }
}

}  // namespace node_interfaces
}  // namespace rclcpp
