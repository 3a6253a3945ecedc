#pragma once

#include <string>

namespace ament_index_cpp
{

/// Whether there is a resource, and where: its prefix is put into `prefix_path`.
bool has_resource(
  const std::string & resource_type, const std::string & resource_name,
  std::string * prefix_path = nullptr);

}  // namespace ament_index_cpp
