#pragma once

#include <string>

#include "ament_index_cpp/get_package_prefix.hpp"

namespace ament_index_cpp
{

/// The folder of the files that a package installs to its share directory; they come with the program.
/// Throws PackageNotFoundError.
std::string get_package_share_directory(const std::string & package_name);

}  // namespace ament_index_cpp
