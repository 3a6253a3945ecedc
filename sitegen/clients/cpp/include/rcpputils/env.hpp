// The environment of a program in a page is initially empty.
#pragma once

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace rcpputils
{

inline std::string get_env_var(const char * name)
{
  const char * found = std::getenv(name);
  return found ? found : "";
}

/// If `value` is null, the variable is removed.
inline bool set_env_var(const char * name, const char * value)
{
  const bool done = name && (value ? setenv(name, value, 1) : unsetenv(name)) == 0;
  if (!done) {throw std::runtime_error("could not set the environment variable");}
  return true;
}

}  // namespace rcpputils
