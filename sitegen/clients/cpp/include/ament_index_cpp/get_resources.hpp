#pragma once

#include <map>
#include <string>

namespace ament_index_cpp
{

/// The prefix of each resource of a type, by its name.
std::map<std::string, std::string> get_resources(const std::string & resource_type);

}  // namespace ament_index_cpp
