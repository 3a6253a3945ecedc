// Queries of a node's parameters; node_parameters.cpp changes them.
#include <algorithm>
#include <set>

#include "rclcpp/node_interfaces/node_parameters_interface.hpp"

namespace rclcpp
{
namespace node_interfaces
{

// Strong reference: also links the implementation into programs that only query parameters.
[[gnu::used]] NodeParametersInterface::SharedPtr (* const made)(
  NodeParametersInterface::SharedPtr) = &NodeParametersInterface::linked;

Parameter NodeParametersInterface::get_parameter(const std::string & name) const
{
  const auto found = parameters_.find(name);
  if (found == parameters_.end()) {
    if (allow_undeclared_) {return Parameter(name);}
    throw exceptions::ParameterNotDeclaredException(name);
  }
  const bool initialized = found->second.value.get_type() != PARAMETER_NOT_SET ||
    found->second.descriptor.dynamic_typing;
  if (!initialized) {throw exceptions::ParameterUninitializedException(name);}
  return Parameter(name, found->second.value);
}

bool NodeParametersInterface::get_parameter(const std::string & name, Parameter & parameter) const
{
  const auto found = parameters_.find(name);
  if (found == parameters_.end() || found->second.value.get_type() == PARAMETER_NOT_SET) {
    return false;
  }
  parameter = Parameter(name, found->second.value);
  return true;
}

std::vector<Parameter> NodeParametersInterface::get_parameters(
  const std::vector<std::string> & names) const
{
  std::vector<Parameter> found;
  for (const auto & name : names) {found.push_back(get_parameter(name));}
  return found;
}

bool NodeParametersInterface::get_parameters_by_prefix(
  const std::string & prefix, std::map<std::string, Parameter> & parameters) const
{
  const std::string start = prefix.empty() ? "" : prefix + ".";
  bool any = false;
  for (const auto & [name, info] : parameters_) {
    if (name.size() <= start.size() || name.compare(0, start.size(), start) != 0) {continue;}
    parameters[name.substr(start.size())] = Parameter(name, info.value);
    any = true;
  }
  return any;
}

std::vector<NodeParametersInterface::Descriptor> NodeParametersInterface::describe_parameters(
  const std::vector<std::string> & names) const
{
  std::vector<Descriptor> found;
  for (const auto & name : names) {
    const auto info = parameters_.find(name);
    if (info != parameters_.end()) {
      found.push_back(info->second.descriptor);
    } else if (allow_undeclared_) {
      found.emplace_back();
      found.back().name = name;
    } else {
      throw exceptions::ParameterNotDeclaredException(name);
    }
  }
  return found;
}

std::vector<std::uint8_t> NodeParametersInterface::get_parameter_types(
  const std::vector<std::string> & names) const
{
  std::vector<std::uint8_t> types;
  for (const auto & name : names) {
    const auto info = parameters_.find(name);
    if (info == parameters_.end() && !allow_undeclared_) {
      throw exceptions::ParameterNotDeclaredException(name);
    }
    types.push_back(info == parameters_.end() ? PARAMETER_NOT_SET : info->second.value.get_type());
  }
  return types;
}

rcl_interfaces::msg::ListParametersResult NodeParametersInterface::list_parameters(
  const std::vector<std::string> & prefixes, std::uint64_t depth) const
{
  rcl_interfaces::msg::ListParametersResult result;
  std::set<std::string> found;
  const auto level = [](const std::string & name) {
      return static_cast<std::uint64_t>(std::count(name.begin(), name.end(), '.'));
    };
  for (const auto & [name, info] : parameters_) {
    bool listed = prefixes.empty() && (depth == 0 || level(name) < depth);
    for (const auto & prefix : prefixes) {
      const bool below = name.rfind(prefix + ".", 0) == 0;
      const bool near = depth == 0 || level(name) < level(prefix) + depth + 1;
      listed = listed || name == prefix || (below && near);
    }
    if (!listed) {continue;}
    result.names.push_back(name);
    const auto dot = name.rfind('.');
    const std::string prefix = dot == std::string::npos ? "" : name.substr(0, dot);
    if (!prefix.empty() && found.insert(prefix).second) {result.prefixes.push_back(prefix);}
  }
  return result;
}

}  // namespace node_interfaces
}  // namespace rclcpp
