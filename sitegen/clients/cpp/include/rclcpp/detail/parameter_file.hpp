// Parameter files that are read while a program runs. Those on a command line are read when the
// site is built.
#pragma once

#include <string>
#include <vector>

#include "rclcpp/detail/yaml.hpp"
#include "rclcpp/parameter.hpp"

namespace rclcpp
{
namespace detail
{

struct NodeParameters
{
  std::string node;  // as in the file: `arm/left`, `/**`
  std::vector<Parameter> parameters;
};

/// The parameters in a file, by node. Throws exceptions::RCLError.
std::vector<NodeParameters> read_parameter_file(const std::string & path);

/// The value of a scalar or a list of scalars; not set for an empty list. Throws
/// exceptions::RCLError.
ParameterValue parameter_value(const Yaml & node);

}  // namespace detail
}  // namespace rclcpp
