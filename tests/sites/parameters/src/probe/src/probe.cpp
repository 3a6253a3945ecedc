// Prints the parameters that it is given, a line each: name, type, value.
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"

static std::string text(bool value) {return value ? "True" : "False";}
static std::string text(std::int64_t value) {return std::to_string(value);}
static std::string text(const std::string & value) {return value;}
static std::string text(double value)
{
  if (std::isnan(value)) {return "nan";}
  char digits[32];
  std::snprintf(digits, sizeof(digits), "%.17g", value);
  return digits;
}

template<class T>
static std::string text(const std::vector<T> & values)
{
  std::string joined;
  for (const auto & value : values) {joined += (joined.empty() ? "" : "|") + text(T(value));}
  return joined;
}

static std::string text(const rclcpp::ParameterValue & value)
{
  switch (value.get_type()) {
    case rclcpp::PARAMETER_BOOL: return text(value.get<bool>());
    case rclcpp::PARAMETER_INTEGER: return text(value.get<std::int64_t>());
    case rclcpp::PARAMETER_DOUBLE: return text(value.get<double>());
    case rclcpp::PARAMETER_STRING: return text(value.get<std::string>());
    case rclcpp::PARAMETER_BOOL_ARRAY: return text(value.get<std::vector<bool>>());
    case rclcpp::PARAMETER_INTEGER_ARRAY: return text(value.get<std::vector<std::int64_t>>());
    case rclcpp::PARAMETER_DOUBLE_ARRAY: return text(value.get<std::vector<double>>());
    case rclcpp::PARAMETER_STRING_ARRAY: return text(value.get<std::vector<std::string>>());
    default: return "";
  }
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<rclcpp::Node>("probe", "/q");
  // A parameter that is asked for brings the rest of them.
  node->declare_parameter("own", 0);
  for (const auto & [name, value] :
    node->get_node_parameters_interface()->get_parameter_overrides())
  {
    const std::string type = rclcpp::to_string(value.get_type());
    std::printf("%s %s %s\n", name.c_str(), type.c_str(), text(value).c_str());
  }
  rclcpp::shutdown();
}
