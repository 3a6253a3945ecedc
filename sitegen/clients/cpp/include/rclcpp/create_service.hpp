#pragma once

#include <memory>
#include <string>
#include <utility>

#include "rclcpp/node_interfaces/get_node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_parts.hpp"
#include "rclcpp/service.hpp"

namespace rclcpp
{

template<class ServiceT, class CallbackT, class NodeT>
std::shared_ptr<Service<ServiceT>> create_service(
  NodeT && node, const std::string & service_name, CallbackT && callback,
  const QoS & qos = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
{
  const auto base = node_interfaces::get_node_base_interface(node);
  auto service = std::make_shared<Service<ServiceT>>(
    *base, service_name, qos, std::forward<CallbackT>(callback));
  base->add(detail::ExecutableKind::kService, service, group);
  return service;
}
/// As upstream, for node interfaces.
template<class ServiceT, class CallbackT>
std::shared_ptr<Service<ServiceT>> create_service(
  node_interfaces::NodeBaseInterface::SharedPtr base,
  node_interfaces::NodeServicesInterface::SharedPtr, const std::string & service_name,
  CallbackT && callback, const QoS & qos, CallbackGroup::SharedPtr group)
{
  return create_service<ServiceT>(
    base, service_name, std::forward<CallbackT>(callback), qos, group);
}
/// The signature of Humble.
template<class ServiceT, class CallbackT>
std::shared_ptr<Service<ServiceT>> create_service(
  node_interfaces::NodeBaseInterface::SharedPtr base,
  node_interfaces::NodeServicesInterface::SharedPtr, const std::string & service_name,
  CallbackT && callback, const rmw_qos_profile_t & qos, CallbackGroup::SharedPtr group)
{
  return create_service<ServiceT>(
    base, service_name, std::forward<CallbackT>(callback),
    QoS(QoSInitialization::from_rmw(qos), qos), group);
}

}  // namespace rclcpp
