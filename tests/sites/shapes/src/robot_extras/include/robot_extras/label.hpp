#pragma once

#include <string>

#include <robot_units/units.hpp>
#include <std_msgs/msg/string.hpp>

namespace robot_extras
{
inline std_msgs::msg::String label(const std::string & text)
{
  std_msgs::msg::String message;
  message.data = "[" + text + "]";
  return message;
}
}  // namespace robot_extras
