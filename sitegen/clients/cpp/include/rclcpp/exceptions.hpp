#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace rclcpp
{
namespace exceptions
{

class UnknownROSArgsError : public std::runtime_error
{
public:
  explicit UnknownROSArgsError(std::vector<std::string> && unknown_ros_args_in);

  const std::vector<std::string> unknown_ros_args;
};

}  // namespace exceptions
}  // namespace rclcpp
