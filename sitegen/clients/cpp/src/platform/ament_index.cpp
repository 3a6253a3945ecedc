#include <dirent.h>
#include <sys/stat.h>

#include <fstream>
#include <sstream>

#include "ament_index_cpp/get_package_share_directory.hpp"
#include "ament_index_cpp/get_packages_with_prefixes.hpp"
#include "ament_index_cpp/get_resource.hpp"
#include "ament_index_cpp/get_resources.hpp"
#include "ament_index_cpp/has_resource.hpp"

namespace ament_index_cpp
{

namespace
{
// The prefix of package files in a program's file system (share/ament_index_cpp/cmake).
const char * const kPrefix = "/ros";

std::string index_of(const std::string & resource_type)
{
  return std::string(kPrefix) + "/share/ament_index/resource_index/" + resource_type;
}
}  // namespace

PackageNotFoundError::PackageNotFoundError(const std::string & package)
: std::out_of_range("package '" + package + "' not found, searching: [" + kPrefix + "]"),
  package_name(package)
{
}

bool has_resource(
  const std::string & resource_type, const std::string & resource_name, std::string * prefix_path)
{
  struct stat found;
  const std::string file = index_of(resource_type) + "/" + resource_name;
  if (resource_name.empty() || stat(file.c_str(), &found) != 0) {return false;}
  if (prefix_path) {*prefix_path = kPrefix;}
  return true;
}

bool get_resource(
  const std::string & resource_type, const std::string & resource_name, std::string & content,
  std::string * prefix_path)
{
  if (!has_resource(resource_type, resource_name, prefix_path)) {return false;}
  std::stringstream all;
  all << std::ifstream(index_of(resource_type) + "/" + resource_name).rdbuf();
  content = all.str();
  return true;
}

std::map<std::string, std::string> get_resources(const std::string & resource_type)
{
  std::map<std::string, std::string> found;
  DIR * folder = opendir(index_of(resource_type).c_str());
  if (!folder) {return found;}
  while (const dirent * entry = readdir(folder)) {
    if (entry->d_name[0] != '.') {found.emplace(entry->d_name, kPrefix);}
  }
  closedir(folder);
  return found;
}

std::map<std::string, std::string> get_packages_with_prefixes()
{
  return get_resources("packages");
}

std::string get_package_prefix(const std::string & package_name)
{
  if (!has_resource("packages", package_name)) {throw PackageNotFoundError(package_name);}
  return kPrefix;
}

std::string get_package_share_directory(const std::string & package_name)
{
  return get_package_prefix(package_name) + "/share/" + package_name;
}

}  // namespace ament_index_cpp
