#include <cmath>
#include <cstdio>

#include "robot_arm/arm.hpp"
#include "robot_base/base.hpp"
#include "robot_nodes/common.hpp"
#include "robot_units/units.hpp"

int main()
{
  const robot_interfaces::msg::Wheel wheel;
  std::printf(
    "%s, %s, %g\n", greeting(robot_base::wheels()).c_str(), robot_arm::hold(wheel).c_str(),
    std::round(kInch * 10000));
}
