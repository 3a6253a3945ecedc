#pragma once

#include <string>
#include <vector>

namespace rcpputils
{

inline std::vector<std::string> split(
  const std::string & input, char delimiter, bool skip_empty = false)
{
  std::vector<std::string> parts;
  if (input.empty()) {return parts;}
  std::size_t begin = 0;
  while (true) {
    const auto end = input.find(delimiter, begin);
    const auto part = input.substr(begin, end == std::string::npos ? end : end - begin);
    if (!part.empty() || !skip_empty) {parts.push_back(part);}
    if (end == std::string::npos) {return parts;}
    begin = end + 1;
  }
}

}  // namespace rcpputils
