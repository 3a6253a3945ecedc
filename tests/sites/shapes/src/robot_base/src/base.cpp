#include "robot_base/base.hpp"

#include "robot_interfaces/msg/chassis.hpp"

int robot_base::wheels()
{
  return static_cast<int>(robot_interfaces::msg::Chassis().wheels.size());
}
