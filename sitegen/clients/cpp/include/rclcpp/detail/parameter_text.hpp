// Parameter values as text: on the command line, `-p name:=value`, and in files.
#pragma once

#include <string>
#include <vector>

#include "rclcpp/parameter_value.hpp"

namespace rclcpp
{
namespace detail
{

/// Read a value as rcl reads YAML: a scalar or a list `[1, 2]` of scalars of one type. Throws
/// std::invalid_argument for other forms.
ParameterValue parse_parameter(const std::string & text);

/// Read a scalar that has no quotes.
ParameterValue parse_scalar(const std::string & text);

/// Scalars as one value, not set if there are none. Throws ParameterTypeException for scalars of several
/// types.
ParameterValue array_of(const std::vector<ParameterValue> & values);

}  // namespace detail
}  // namespace rclcpp
