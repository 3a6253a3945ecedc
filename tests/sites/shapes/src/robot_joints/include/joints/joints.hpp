#pragma once

#include "joints/version.hpp"

namespace joints
{
constexpr double kHalfTurn = 3.141592653589793;
double degrees(double radians);
}  // namespace joints
