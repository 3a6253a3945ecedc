#include "joints/joints.hpp"

namespace joints
{
double degrees(double radians) {return radians * 180 / kHalfTurn;}
}  // namespace joints
