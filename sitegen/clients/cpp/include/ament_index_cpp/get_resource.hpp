#pragma once

#include <string>

namespace ament_index_cpp
{

/// Read a resource; false if it does not exist. Its prefix is returned in `prefix_path`.
bool get_resource(
  const std::string & resource_type, const std::string & resource_name, std::string & content,
  std::string * prefix_path = nullptr);

}  // namespace ament_index_cpp
