#pragma once

#include <memory>
#include <utility>

#include "rclcpp/node.hpp"

/// For NodeInterfaces with all of them.
#define ALL_RCLCPP_NODE_INTERFACES \
  rclcpp::node_interfaces::NodeBaseInterface, \
  rclcpp::node_interfaces::NodeClockInterface, \
  rclcpp::node_interfaces::NodeGraphInterface, \
  rclcpp::node_interfaces::NodeLoggingInterface, \
  rclcpp::node_interfaces::NodeParametersInterface, \
  rclcpp::node_interfaces::NodeServicesInterface, \
  rclcpp::node_interfaces::NodeTimeSourceInterface, \
  rclcpp::node_interfaces::NodeTimersInterface, \
  rclcpp::node_interfaces::NodeTopicsInterface, \
  rclcpp::node_interfaces::NodeWaitablesInterface

namespace rclcpp
{
namespace node_interfaces
{

namespace detail
{

/// For each interface of a node: the method that returns it, and its name in NodeInterfaces.
template<class InterfaceT>
struct Part;

#define ROS_NODE_INTERFACE(Interface, name) \
  template<> \
  struct Part<Interface> \
  { \
    template<class NodeT> \
    static std::shared_ptr<Interface> of(NodeT & node) {return node.get_ ## name();} \
    std::shared_ptr<Interface> get_ ## name() const {return part;} \
    std::shared_ptr<Interface> part; \
  };

ROS_NODE_INTERFACE(NodeBaseInterface, node_base_interface)
ROS_NODE_INTERFACE(NodeClockInterface, node_clock_interface)
ROS_NODE_INTERFACE(NodeGraphInterface, node_graph_interface)
ROS_NODE_INTERFACE(NodeLoggingInterface, node_logging_interface)
ROS_NODE_INTERFACE(NodeParametersInterface, node_parameters_interface)
ROS_NODE_INTERFACE(NodeServicesInterface, node_services_interface)
ROS_NODE_INTERFACE(NodeTimersInterface, node_timers_interface)
ROS_NODE_INTERFACE(NodeTimeSourceInterface, node_time_source_interface)
ROS_NODE_INTERFACE(NodeTopicsInterface, node_topics_interface)
ROS_NODE_INTERFACE(NodeWaitablesInterface, node_waitables_interface)

#undef ROS_NODE_INTERFACE

}  // namespace detail

/// Some interfaces of a node, whatever its class.
template<class ... InterfaceTs>
class NodeInterfaces : public detail::Part<InterfaceTs>...
{
public:
  /// From an object that has these interfaces.
  template<class NodeT, class = decltype(std::declval<NodeT &>().get_node_base_interface())>
  NodeInterfaces(NodeT & node)  // NOLINT: implicit upstream
  : detail::Part<InterfaceTs>{detail::Part<InterfaceTs>::of(node)}... {}
  explicit NodeInterfaces(std::shared_ptr<InterfaceTs>... parts)
  : detail::Part<InterfaceTs>{std::move(parts)}... {}

  template<class InterfaceT>
  std::shared_ptr<InterfaceT> get() const
  {
    return static_cast<const detail::Part<InterfaceT> &>(*this).part;
  }
};

}  // namespace node_interfaces
}  // namespace rclcpp
