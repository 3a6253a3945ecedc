#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "rclcpp/node_interfaces/node_base_interface.hpp"

namespace rclcpp_components
{

/// A node of any class.
class NodeInstanceWrapper
{
public:
  using NodeBaseInterfaceGetter =
    std::function<rclcpp::node_interfaces::NodeBaseInterface::SharedPtr(
        const std::shared_ptr<void> &)>;

  NodeInstanceWrapper() = default;
  NodeInstanceWrapper(std::shared_ptr<void> node_instance, NodeBaseInterfaceGetter getter)
  : node_instance_(std::move(node_instance)), getter_(std::move(getter)) {}

  std::shared_ptr<void> get_node_instance() const {return node_instance_;}
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr get_node_base_interface()
  {
    return getter_(node_instance_);
  }

private:
  std::shared_ptr<void> node_instance_;
  NodeBaseInterfaceGetter getter_;
};

}  // namespace rclcpp_components
