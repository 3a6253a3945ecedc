#include <sys/stat.h>

#include "ament_index_cpp/get_package_share_directory.hpp"

namespace ament_index_cpp
{

namespace
{
// Where the files of packages are in a program (share/ament_index_cpp/cmake).
const char * const kPrefix = "/ros";
}  // namespace

PackageNotFoundError::PackageNotFoundError(const std::string & package)
: std::out_of_range("package '" + package + "' not found, searching: [" + kPrefix + "]"),
  package_name(package)
{
}

std::string get_package_prefix(const std::string & package_name)
{
  struct stat found;
  const std::string marker =
    std::string(kPrefix) + "/share/ament_index/resource_index/packages/" + package_name;
  if (package_name.empty() || stat(marker.c_str(), &found) != 0) {
    throw PackageNotFoundError(package_name);
  }
  return kPrefix;
}

std::string get_package_share_directory(const std::string & package_name)
{
  return get_package_prefix(package_name) + "/share/" + package_name;
}

}  // namespace ament_index_cpp
