#pragma once

#include <memory>
#include <string>

#include "rclcpp/detail/any_node.hpp"

namespace rclcpp
{

class Node : public detail::AnyNode, public std::enable_shared_from_this<Node>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Node)

  explicit Node(const std::string & name, const NodeOptions & options = NodeOptions())
  : Node(name, "", options) {}
  Node(
    const std::string & name, const std::string & name_space,
    const NodeOptions & options = NodeOptions())
  : AnyNode(name, name_space, options) {}

  /// The same node with `sub_namespace` as a prefix of relative names.
  SharedPtr create_sub_node(const std::string & sub_namespace);

protected:
  Node(const Node & other, const std::string & sub_namespace)
  : AnyNode(other, sub_namespace), std::enable_shared_from_this<Node>() {}
};

}  // namespace rclcpp
