#include "rclcpp/parameter_map.hpp"

#include "rclcpp/detail/arguments.hpp"
#include "rclcpp/detail/parameter_file.hpp"

namespace rclcpp
{

using exceptions::InvalidParametersException;
using exceptions::InvalidParameterValueException;

namespace
{

/// The node name under which the parameters of `rule` are entered for `node_fqn`; empty if no match.
std::string node_name(const std::string & rule, const char * node_fqn)
{
  const std::string name = rule.rfind('/', 0) == 0 ? rule : "/" + rule;
  if (!node_fqn) {return name;}
  return detail::applies_to(name, node_fqn) ? node_fqn : "";
}

template<class T, class ArrayT>
ParameterValue array_from(const ArrayT & array)
{
  return ParameterValue(std::vector<T>(array.values, array.values + array.size));
}

}  // namespace

ParameterMap parameter_map_from(const rcl_params_t * const c_params, const char * node_fqn)
{
  if (!c_params) {throw InvalidParametersException("parameters struct is NULL");}
  if (!c_params->node_names) {throw InvalidParametersException("node names array is NULL");}
  if (!c_params->params) {throw InvalidParametersException("node params array is NULL");}
  ParameterMap map;
  for (std::size_t n = 0; n < c_params->num_nodes; ++n) {
    if (!c_params->node_names[n]) {
      throw InvalidParametersException("Node name at index " + std::to_string(n) + " is NULL");
    }
    const std::string name = node_name(c_params->node_names[n], node_fqn);
    if (name.empty()) {continue;}
    auto & parameters = map[name];
    const auto & node = c_params->params[n];
    for (std::size_t i = 0; i < node.num_params; ++i) {
      if (!node.parameter_names[i]) {
        throw InvalidParametersException(
                "At node " + std::to_string(n) + " parameter " + std::to_string(i) +
                " name is NULL");
      }
      parameters.emplace_back(
        node.parameter_names[i], parameter_value_from(&node.parameter_values[i]));
    }
  }
  return map;
}

ParameterValue parameter_value_from(const rcl_variant_t * const c_value)
{
  if (!c_value) {throw InvalidParameterValueException("Passed argument is NULL");}
  if (c_value->bool_value) {return ParameterValue(*c_value->bool_value);}
  if (c_value->integer_value) {return ParameterValue(*c_value->integer_value);}
  if (c_value->double_value) {return ParameterValue(*c_value->double_value);}
  if (c_value->string_value) {return ParameterValue(std::string(c_value->string_value));}
  if (c_value->byte_array_value) {return array_from<std::uint8_t>(*c_value->byte_array_value);}
  if (c_value->bool_array_value) {return array_from<bool>(*c_value->bool_array_value);}
  if (c_value->integer_array_value) {
    return array_from<std::int64_t>(*c_value->integer_array_value);
  }
  if (c_value->double_array_value) {return array_from<double>(*c_value->double_array_value);}
  if (const auto * strings = c_value->string_array_value) {
    return ParameterValue(std::vector<std::string>(strings->data, strings->data + strings->size));
  }
  throw InvalidParameterValueException("No parameter value set");
}

ParameterMap parameter_map_from_yaml_file(
  const std::string & yaml_filename, const char * node_fqn)
{
  ParameterMap map;
  for (const auto & node : detail::read_parameter_file(yaml_filename)) {
    const std::string name = node_name(node.node, node_fqn);
    if (name.empty()) {continue;}
    auto & parameters = map[name];
    for (const auto & one : node.parameters) {
      if (one.get_type() == PARAMETER_NOT_SET) {
        throw InvalidParameterValueException("No parameter value set");
      }
      parameters.push_back(one);
    }
  }
  return map;
}

std::vector<Parameter> parameters_from_map(
  const ParameterMap & parameter_map, const char * node_fqn)
{
  std::vector<Parameter> parameters;
  for (const auto & [name, of_node] : parameter_map) {
    if (node_fqn && node_name(name, node_fqn).empty()) {continue;}
    parameters.insert(parameters.end(), of_node.begin(), of_node.end());
  }
  return parameters;
}

}  // namespace rclcpp
