#pragma once

#include <algorithm>

namespace rcppmath
{

using std::clamp;

}  // namespace rcppmath
