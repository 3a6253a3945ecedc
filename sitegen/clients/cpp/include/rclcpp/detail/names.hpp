// The rules of ROS 2 for names of nodes, topics and services.
#pragma once

#include <string>

namespace rclcpp
{
namespace detail
{

/// These throw InvalidNodeNameError and InvalidNamespaceError in upstream's words.
void validate_node_name(const std::string & name);
void validate_namespace(const std::string & name_space);

enum class NameKind {Topic, Service};

/// `name` as a full name: absolute stays, "~" is the node, everything else is in the namespace; {node},
/// {ns} and {namespace} are filled in. Throws InvalidTopicNameError or InvalidServiceNameError.
std::string expand_name(
  const std::string & node, const std::string & name_space, const std::string & name,
  NameKind kind);

/// The logger of a node is named by its full name, with dots.
std::string logger_name(std::string full_node_name);

}  // namespace detail
}  // namespace rclcpp
