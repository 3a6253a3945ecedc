#pragma once

#include <dlfcn.h>
#include <sys/stat.h>

#include <string>

namespace rcpputils
{

inline std::string filename_for_library(const std::string & library_name)
{
  return "lib" + library_name + ".so";
}

/// The path of the library in `directory`; empty if it has none.
inline std::string path_for_library(
  const std::string & directory, const std::string & library_name)
{
  struct stat found;
  const std::string path = directory + "/" + filename_for_library(library_name);
  return stat(path.c_str(), &found) == 0 ? path : "";
}

/// A path for dlopen(), or empty if the program is not linked with the library: there are no files.
inline std::string find_library_path(const std::string & library_name)
{
  const std::string path = "/ros/lib/" + filename_for_library(library_name);
  return dlopen(path.c_str(), RTLD_LAZY) ? path : "";
}

}  // namespace rcpputils
