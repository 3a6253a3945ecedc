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

/// Create the parameters of a node and the source of its time. Null in programs that use no
/// parameters, because the parameter services would be half the size of a talker.
__attribute__((weak)) node_interfaces::NodeParametersInterface::SharedPtr make_node_parameters(
  const node_interfaces::NodeBaseInterface::SharedPtr & node, const NodeOptions & options,
  const Clock::SharedPtr & clock, TimeSource::SharedPtr & time_source);

}  // namespace detail
}  // namespace rclcpp
