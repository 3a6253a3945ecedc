#pragma once

#include <string>

namespace ament_index_cpp
{

/// Whether a resource exists. Its prefix is returned in `prefix_path`.
bool has_resource(
  const std::string & resource_type, const std::string & resource_name,
  std::string * prefix_path = nullptr);

}  // namespace ament_index_cpp
