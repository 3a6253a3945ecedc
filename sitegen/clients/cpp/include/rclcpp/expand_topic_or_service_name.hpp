#pragma once

#include <string>

#include "rclcpp/detail/names.hpp"

namespace rclcpp
{

/// The expanded name of a topic or service of the node. Throws InvalidTopicNameError or
/// InvalidServiceNameError.
inline std::string expand_topic_or_service_name(
  const std::string & name, const std::string & node_name, const std::string & namespace_,
  bool is_service = false)
{
  const auto kind = is_service ? detail::NameKind::Service : detail::NameKind::Topic;
  return detail::expand_name(node_name, namespace_, name, kind);
}

}  // namespace rclcpp
