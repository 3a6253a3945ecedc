// The parameter services of a node.
#pragma once

#include <memory>
#include <vector>

#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/service.hpp"

namespace rclcpp
{
namespace node_interfaces
{
class NodeParametersInterface;
}  // namespace node_interfaces

namespace detail
{

class ParameterServices
{
public:
  ParameterServices(
    node_interfaces::NodeBaseInterface & node,
    node_interfaces::NodeParametersInterface & parameters, const QoS & qos = ParametersQoS());

private:
  std::vector<std::shared_ptr<ServiceBase>> services_;
};

}  // namespace detail
}  // namespace rclcpp
