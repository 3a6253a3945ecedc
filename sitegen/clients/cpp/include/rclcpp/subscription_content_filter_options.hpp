#pragma once

#include <string>
#include <vector>

namespace rclcpp
{

/// A DDS filter expression, such as "data > %0", and the values of %0, %1, ….
struct ContentFilterOptions
{
  std::string filter_expression;
  std::vector<std::string> expression_parameters;
};

}  // namespace rclcpp
