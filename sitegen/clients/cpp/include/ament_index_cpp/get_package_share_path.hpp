#pragma once

#include <filesystem>
#include <string>

#include "ament_index_cpp/get_package_share_directory.hpp"

namespace ament_index_cpp
{

/// As get_package_share_directory(), as a path.
inline std::filesystem::path get_package_share_path(const std::string & package_name)
{
  return get_package_share_directory(package_name);
}

}  // namespace ament_index_cpp
