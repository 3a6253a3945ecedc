#pragma once

#include <memory>
#include <string>

#include "rclcpp/generic_client.hpp"
#include "rclcpp/node_interfaces/get_node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_parts.hpp"

namespace rclcpp
{

template<class NodeT>
std::shared_ptr<GenericClient> create_generic_client(
  NodeT && node, const std::string & service_name, const std::string & service_type,
  const QoS & qos = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
{
  const auto base = node_interfaces::get_node_base_interface(node);
  auto client = std::make_shared<GenericClient>(*base, service_name, service_type, qos);
  base->add(detail::ExecutableKind::kClient, client, group);
  return client;
}
/// As upstream, for node interfaces.
template<class GraphT>
std::shared_ptr<GenericClient> create_generic_client(
  node_interfaces::NodeBaseInterface::SharedPtr base, std::shared_ptr<GraphT>,
  node_interfaces::NodeServicesInterface::SharedPtr, const std::string & service_name,
  const std::string & service_type, const QoS & qos = ServicesQoS(),
  CallbackGroup::SharedPtr group = nullptr)
{
  return create_generic_client(base, service_name, service_type, qos, group);
}

}  // namespace rclcpp
