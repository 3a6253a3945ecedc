#pragma once

#include <memory>

#include "rclcpp/detail/parameter_services.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/node_interfaces/node_services_interface.hpp"
#include "rclcpp/qos.hpp"

namespace rclcpp
{

/// The parameter services of a node that is started without them.
class ParameterService : public detail::ParameterServices
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterService)

  ParameterService(
    std::shared_ptr<node_interfaces::NodeBaseInterface> base,
    std::shared_ptr<node_interfaces::NodeServicesInterface>,
    node_interfaces::NodeParametersInterface * parameters, const QoS & qos = ParametersQoS())
  : detail::ParameterServices(*base, *parameters, qos) {}
  /// The signature of Humble.
  ParameterService(
    std::shared_ptr<node_interfaces::NodeBaseInterface> base,
    std::shared_ptr<node_interfaces::NodeServicesInterface>,
    node_interfaces::NodeParametersInterface * parameters, const rmw_qos_profile_t & qos)
  : detail::ParameterServices(
      *base, *parameters, QoS(QoSInitialization::from_rmw(qos), qos)) {}
};

}  // namespace rclcpp
