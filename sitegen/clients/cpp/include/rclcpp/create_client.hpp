#pragma once

#include <memory>
#include <string>

#include "rclcpp/client.hpp"
#include "rclcpp/node_interfaces/get_node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_parts.hpp"

namespace rclcpp
{

template<class ServiceT, class NodeT>
std::shared_ptr<Client<ServiceT>> create_client(
  NodeT && node, const std::string & service_name, const QoS & qos = ServicesQoS(),
  CallbackGroup::SharedPtr group = nullptr)
{
  const auto base = node_interfaces::get_node_base_interface(node);
  auto client = std::make_shared<Client<ServiceT>>(*base, service_name, qos);
  base->add(detail::ExecutableKind::kClient, client, group);
  return client;
}
/// As upstream, for node interfaces.
template<class ServiceT, class GraphT>
std::shared_ptr<Client<ServiceT>> create_client(
  node_interfaces::NodeBaseInterface::SharedPtr base, std::shared_ptr<GraphT>,
  node_interfaces::NodeServicesInterface::SharedPtr, const std::string & service_name,
  const QoS & qos = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
{
  return create_client<ServiceT>(base, service_name, qos, group);
}
/// The signature of Humble.
template<class ServiceT, class GraphT>
std::shared_ptr<Client<ServiceT>> create_client(
  node_interfaces::NodeBaseInterface::SharedPtr base, std::shared_ptr<GraphT>,
  node_interfaces::NodeServicesInterface::SharedPtr, const std::string & service_name,
  const rmw_qos_profile_t & qos, CallbackGroup::SharedPtr group = nullptr)
{
  return create_client<ServiceT>(
    base, service_name, QoS(QoSInitialization::from_rmw(qos), qos), group);
}

}  // namespace rclcpp
