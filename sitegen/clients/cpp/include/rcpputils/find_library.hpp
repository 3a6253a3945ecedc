#pragma once

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

/// Always empty: libraries are linked into the program, so a page has no files of them.
inline std::string find_library_path(const std::string &) {return "";}

}  // namespace rcpputils
