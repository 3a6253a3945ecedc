#pragma once

#include <string>

namespace rcpputils
{

inline std::string find_and_replace(
  const std::string & input, const std::string & find, const std::string & replace)
{
  std::string output = input;
  if (find.empty()) {return output;}
  for (std::size_t at = output.find(find); at != std::string::npos;
    at = output.find(find, at + replace.size()))
  {
    output.replace(at, find.size(), replace);
  }
  return output;
}

}  // namespace rcpputils
