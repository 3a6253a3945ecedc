// Creates the parameters of a node, only in programs that use parameters.
#pragma once

#include <memory>

#include "rclcpp/clock.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/time_source.hpp"

namespace rclcpp
{
namespace detail
{

/// Make the parameters of a node and what sets its clock. Null in programs that use no parameters: half
/// of a talker would be the services for them.
__attribute__((weak)) node_interfaces::NodeParametersInterface::SharedPtr make_node_parameters(
  const node_interfaces::NodeBaseInterface::SharedPtr & node, const NodeOptions & options,
  const Clock::SharedPtr & clock, TimeSource::SharedPtr & time_source);

}  // namespace detail
}  // namespace rclcpp
