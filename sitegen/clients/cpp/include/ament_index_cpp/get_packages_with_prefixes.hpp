#pragma once

#include <map>
#include <string>

namespace ament_index_cpp
{

/// The prefix of each package whose files are available to the program.
std::map<std::string, std::string> get_packages_with_prefixes();

}  // namespace ament_index_cpp
