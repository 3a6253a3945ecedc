#pragma once

#include <errno.h>

#include <string>

namespace rcpputils
{

/// The last part of the path of the program.
inline std::string get_executable_name() {return program_invocation_short_name;}

}  // namespace rcpputils
