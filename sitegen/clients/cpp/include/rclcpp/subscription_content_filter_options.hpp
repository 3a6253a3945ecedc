#pragma once

#include <string>
#include <vector>

namespace rclcpp
{

/// An expression of DDS, such as "data > %0", and what stands for %0, %1, ….
struct ContentFilterOptions
{
  std::string filter_expression;
  std::vector<std::string> expression_parameters;
};

}  // namespace rclcpp
