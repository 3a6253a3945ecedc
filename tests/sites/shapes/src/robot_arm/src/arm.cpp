#include "robot_arm/arm.hpp"

std::string robot_arm::hold(const robot_interfaces::msg::Wheel & wheel)
{
  return "holds " + wheel.label;
}
