#pragma once

#include <map>
#include <string>

namespace ament_index_cpp
{

/// The prefix of each package whose files the program has.
std::map<std::string, std::string> get_packages_with_prefixes();

}  // namespace ament_index_cpp
