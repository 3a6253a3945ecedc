#pragma once

#include <functional>
#include <list>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/parameter.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/subscription.hpp"

namespace rclcpp
{

struct ParameterCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterCallbackHandle)

  using ParameterCallbackType = std::function<void (const Parameter &)>;
  std::string parameter_name;
  std::string node_name;
  ParameterCallbackType callback;
};

struct ParameterEventCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterEventCallbackHandle)

  using ParameterEventCallbackType =
    std::function<void (const rcl_interfaces::msg::ParameterEvent &)>;
  ParameterEventCallbackType callback;
};

/// Runs callbacks when parameters of any node change.
class ParameterEventHandler
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterEventHandler)

  using Event = rcl_interfaces::msg::ParameterEvent;
  using ParameterCallbackType = ParameterCallbackHandle::ParameterCallbackType;
  using ParameterEventCallbackType = ParameterEventCallbackHandle::ParameterEventCallbackType;

  template<class NodeT>
  explicit ParameterEventHandler(NodeT node, const QoS & qos = ParameterEventsQoS())
  : ParameterEventHandler(node->get_node_base_interface(), qos) {}
  explicit ParameterEventHandler(
    node_interfaces::NodeBaseInterface::SharedPtr node, const QoS & qos = ParameterEventsQoS());

  /// Keep the handle: the callback is removed with it.
  ParameterEventCallbackHandle::SharedPtr add_parameter_event_callback(
    ParameterEventCallbackType callback);
  void remove_parameter_event_callback(ParameterEventCallbackHandle::SharedPtr handle);
  /// For a parameter of the node `node_name`; if empty, of its own node.
  ParameterCallbackHandle::SharedPtr add_parameter_callback(
    const std::string & parameter_name, ParameterCallbackType callback,
    const std::string & node_name = "");
  void remove_parameter_callback(ParameterCallbackHandle::SharedPtr handle);

  /// Receive events of these nodes only, of all nodes if the list is empty. Always returns true.
  bool configure_nodes_filter(const std::vector<std::string> & node_names);

  /// Find the new value of a parameter in an event; false if it is not in it.
  static bool get_parameter_from_event(
    const Event & event, Parameter & parameter, const std::string & parameter_name,
    const std::string & node_name = "");
  static Parameter get_parameter_from_event(
    const Event & event, const std::string & parameter_name, const std::string & node_name = "");
  static std::vector<Parameter> get_parameters_from_event(const Event & event);

private:
  void handle(const Event & event);
  /// Relative names are in the namespace of its node.
  std::string resolve(const std::string & node_name) const;

  node_interfaces::NodeBaseInterface::SharedPtr node_;
  std::set<std::string> nodes_;  // of which it hears, all if there are none
  std::list<ParameterCallbackHandle::WeakPtr> of_parameters_;
  std::list<ParameterEventCallbackHandle::WeakPtr> of_events_;
  std::shared_ptr<Subscription<Event>> subscription_;
};

}  // namespace rclcpp
