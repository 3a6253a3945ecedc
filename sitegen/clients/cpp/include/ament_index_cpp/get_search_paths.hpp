#pragma once

#include <list>
#include <string>

#include "ament_index_cpp/visibility_control.h"

namespace ament_index_cpp
{

/// The only prefix of a program in a page. Never throws.
inline std::list<std::string> get_search_paths() {return {"/ros"};}

}  // namespace ament_index_cpp
