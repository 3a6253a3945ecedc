#pragma once

#include <sstream>
#include <string>

namespace rcpputils
{

template<typename T, template<typename ...> class Container, typename ... Args>
std::string join(const Container<T, Args...> & values, const std::string & delimiter)
{
  std::ostringstream text;
  bool first = true;
  for (const auto & value : values) {
    if (!first) {text << delimiter;}
    first = false;
    text << value;
  }
  return text.str();
}

}  // namespace rcpputils
