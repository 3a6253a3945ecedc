// The parameters that a command line gives to a node.
#pragma once

#include <map>
#include <string>

#include "rclcpp/detail/arguments.hpp"
#include "rclcpp/parameter_value.hpp"

namespace rclcpp
{
namespace detail
{

/// The parameters of the node `full_name`, by name. Those of the node itself take precedence over
/// those of the program. Throws what parse_parameter() throws.
std::map<std::string, ParameterValue> overrides_of(
  const Arguments & arguments, const std::string & full_name);

}  // namespace detail
}  // namespace rclcpp
