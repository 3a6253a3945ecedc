#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "rcl_yaml_param_parser/parser.h"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/parameter.hpp"

namespace rclcpp
{

/// The parameters of nodes, by their full names.
using ParameterMap = std::unordered_map<std::string, std::vector<Parameter>>;

/// The parameters for the node `node_fqn`, also by patterns such as `/**`; for all nodes if null. Throws
/// InvalidParametersException if the structure is incomplete.
ParameterMap parameter_map_from(
  const rcl_params_t * const c_params, const char * node_fqn = nullptr);

/// Throws InvalidParameterValueException if there is none.
ParameterValue parameter_value_from(const rcl_variant_t * const c_value);

/// The parameters of a file. Throws RCLError if it cannot be read.
ParameterMap parameter_map_from_yaml_file(
  const std::string & yaml_filename, const char * node_fqn = nullptr);

std::vector<Parameter> parameters_from_map(
  const ParameterMap & parameter_map, const char * node_fqn = nullptr);

}  // namespace rclcpp
