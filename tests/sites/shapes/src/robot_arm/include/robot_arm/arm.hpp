#pragma once

#include <string>

#include "robot_interfaces/msg/wheel.hpp"

namespace robot_arm
{
std::string hold(const robot_interfaces::msg::Wheel & wheel);
}
