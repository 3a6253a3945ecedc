#pragma once

#include <stdexcept>
#include <string>

namespace ament_index_cpp
{

class PackageNotFoundError : public std::out_of_range
{
public:
  explicit PackageNotFoundError(const std::string & package_name);

  std::string package_name;
};

/// Throws PackageNotFoundError.
std::string get_package_prefix(const std::string & package_name);

}  // namespace ament_index_cpp
