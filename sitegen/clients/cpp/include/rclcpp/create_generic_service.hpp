#pragma once

#include <memory>
#include <string>
#include <utility>

#include "rclcpp/generic_service.hpp"
#include "rclcpp/node_interfaces/get_node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_parts.hpp"

namespace rclcpp
{

/// As upstream, for node interfaces.
template<class CallbackT>
std::shared_ptr<GenericService> create_generic_service(
  node_interfaces::NodeBaseInterface::SharedPtr base,
  node_interfaces::NodeServicesInterface::SharedPtr, const std::string & service_name,
  const std::string & service_type, CallbackT && callback, const QoS & qos = ServicesQoS(),
  CallbackGroup::SharedPtr group = nullptr)
{
  auto service = std::make_shared<GenericService>(
    *base, service_name, service_type, qos, std::forward<CallbackT>(callback));
  base->add(detail::ExecutableKind::kService, service, group);
  return service;
}

}  // namespace rclcpp
