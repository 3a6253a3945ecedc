// The rules of ROS 2 for names of nodes, topics and services.
#pragma once

#include <string>

namespace rclcpp
{
namespace detail
{

/// These throw InvalidNodeNameError and InvalidNamespaceError with the messages of upstream.
void validate_node_name(const std::string & name);
void validate_namespace(const std::string & name_space);

enum class NameKind {Topic, Service};

/// Expand `name` to a full name: an absolute name is unchanged, "~" is the node, other names are in
/// the namespace; {node}, {ns} and {namespace} are replaced. Throws InvalidTopicNameError or
/// InvalidServiceNameError.
std::string expand_name(
  const std::string & node, const std::string & name_space, const std::string & name,
  NameKind kind);

/// The name of a node's logger: its full name with dots.
std::string logger_name(std::string full_node_name);

}  // namespace detail
}  // namespace rclcpp
