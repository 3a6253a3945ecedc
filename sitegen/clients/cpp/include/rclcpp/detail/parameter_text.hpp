// Parameter values as text: on the command line, `-p name:=value`, and in files.
#pragma once

#include <string>
#include <vector>

#include "rclcpp/parameter_value.hpp"

namespace rclcpp
{
namespace detail
{

/// Parse a value as rcl parses YAML: a scalar, or a list `[1, 2]` of scalars of one type. Throws
/// std::invalid_argument for a list of several types, exceptions::RCLError for anything else.
ParameterValue parse_parameter(const std::string & value);

/// Parse an unquoted scalar.
ParameterValue parse_scalar(const std::string & text);

/// Combine scalars into one value, which is not set if there are none. Throws
/// ParameterTypeException for scalars of different types.
ParameterValue array_of(const std::vector<ParameterValue> & values);

}  // namespace detail
}  // namespace rclcpp
