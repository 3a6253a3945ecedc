#include "rclcpp/detail/parameter_file.hpp"

#include <algorithm>
#include <cstdio>

#include "rclcpp/detail/parameter_text.hpp"
#include "rclcpp/exceptions.hpp"

namespace rclcpp
{
namespace detail
{

namespace
{

const char kParameters[] = "ros__parameters";

[[noreturn]] void fail(const std::string & what, const char * at, const Yaml & node)
{
  throw exceptions::RCLError(what + at + std::to_string(node.line));
}

std::string read(const std::string & path)
{
  std::FILE * file = std::fopen(path.c_str(), "rb");
  if (!file) {throw exceptions::RCLError("Error opening YAML file");}
  std::string text;
  char part[1024];
  while (const std::size_t size = std::fread(part, 1, sizeof(part), file)) {text.append(part, size);}
  std::fclose(file);
  return text;
}

/// The last parameter of a name takes precedence.
void set(std::vector<Parameter> & parameters, const Parameter & parameter)
{
  for (auto & one : parameters) {
    if (one.get_name() == parameter.get_name()) {
      one = parameter;
      return;
    }
  }
  parameters.push_back(parameter);
}

void add_values(std::vector<Parameter> & parameters, const std::string & prefix, const Yaml & map)
{
  for (const auto & part : map.parts) {
    if (part.kind == Yaml::kMap) {
      add_values(parameters, prefix + part.key + ".", part);
    } else {
      set(parameters, Parameter(prefix + part.key, parameter_value(part)));
    }
  }
}

void add_nodes(std::vector<NodeParameters> & nodes, const std::string & path, const Yaml & map)
{
  for (const auto & part : map.parts) {
    const bool here = part.key == kParameters;
    if (here && path.empty()) {
      fail(std::string("There are no node names before ") + kParameters, " at line ", part);
    }
    if (part.kind != Yaml::kMap) {
      fail(std::string("Cannot have a value before ") + kParameters, " at line ", part);
    }
    if (!here) {
      add_nodes(nodes, path.empty() ? part.key : path + "/" + part.key, part);
      continue;
    }
    auto found = std::find_if(
      nodes.begin(), nodes.end(), [&](const auto & node) {return node.node == path;});
    if (found == nodes.end()) {found = nodes.insert(found, NodeParameters{path, {}});}
    add_values(found->parameters, "", part);
  }
}

const char * type_name(const ParameterValue & value)
{
  switch (value.get_type()) {
    case PARAMETER_BOOL: return "bool";
    case PARAMETER_INTEGER: return "integer";
    case PARAMETER_DOUBLE: return "double";
    default: return "string";
  }
}

ParameterValue scalar(const Yaml & node)
{
  if (node.kind == Yaml::kEmpty) {fail("No value", " at line ", node);}
  if (node.kind != Yaml::kScalar) {fail("Error parsing a event", " near line ", node);}
  return node.quoted ? ParameterValue(node.text) : parse_scalar(node.text);
}

}  // namespace

ParameterValue parameter_value(const Yaml & node)
{
  if (node.kind != Yaml::kList) {return scalar(node);}
  std::vector<ParameterValue> values;
  for (const auto & part : node.parts) {
    values.push_back(scalar(part));
    if (values.back().get_type() != values.front().get_type()) {
      fail(
        "Sequence should be of same type. Value type '" + std::string(type_name(values.back())) +
        "' do not belong", " at line_num ", part);
    }
  }
  return array_of(values);
}

std::vector<NodeParameters> read_parameter_file(const std::string & path)
{
  const Yaml root = read_yaml(read(path));
  std::vector<NodeParameters> nodes;
  if (root.kind == Yaml::kScalar || root.kind == Yaml::kList) {
    fail(std::string("Cannot have a value before ") + kParameters, " at line ", root);
  }
  add_nodes(nodes, "", root);
  return nodes;
}

}  // namespace detail
}  // namespace rclcpp
