// Values of parameters on the command line: `-p name:=value`.
#pragma once

#include <string>

#include "rclcpp/parameter_value.hpp"

namespace rclcpp
{
namespace detail
{

/// Read a value as rcl reads YAML: a scalar or a list `[1, 2]` of scalars of one type. Throws
/// std::invalid_argument for other forms.
ParameterValue parse_parameter(const std::string & text);

}  // namespace detail
}  // namespace rclcpp
