#include "rclcpp/parameter.hpp"

#include <cstdio>
#include <sstream>

namespace rclcpp
{

namespace
{

const char * const kTypes[] = {
  "not set", "bool", "integer", "double", "string", "byte_array", "bool_array", "integer_array",
  "double_array", "string_array"};

std::string quoted(const std::string & text)
{
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {result += '\\';}
    result += c;
  }
  return result + "\"";
}

template<class Vector, class Write>
std::string list(const Vector & values, Write write)
{
  std::string text = "[";
  for (std::size_t i = 0; i < values.size(); ++i) {text += (i ? ", " : "") + write(values[i]);}
  return text + "]";
}

std::string from_bool(bool value) {return value ? "true" : "false";}
std::string from_double(double value) {return std::to_string(value);}
std::string from_integer(std::int64_t value) {return std::to_string(value);}
std::string from_byte(std::uint8_t value)
{
  char text[8];
  std::snprintf(text, sizeof(text), "0x%x", value);
  return text;
}

}  // namespace

std::string to_string(ParameterType type)
{
  return type <= PARAMETER_STRING_ARRAY ? kTypes[type] : "unknown type";
}

std::ostream & operator<<(std::ostream & os, ParameterType type) {return os << to_string(type);}

ParameterTypeException::ParameterTypeException(ParameterType expected, ParameterType actual)
: std::runtime_error("expected [" + to_string(expected) + "] got [" + to_string(actual) + "]")
{
}

void ParameterValue::require(ParameterType type) const
{
  if (get_type() != type) {throw ParameterTypeException(type, get_type());}
}

std::string to_string(const ParameterValue & value)
{
  const auto message = value.to_value_msg();
  switch (value.get_type()) {
    case PARAMETER_BOOL: return from_bool(message.bool_value);
    case PARAMETER_INTEGER: return from_integer(message.integer_value);
    case PARAMETER_DOUBLE: return from_double(message.double_value);
    case PARAMETER_STRING: return message.string_value;
    case PARAMETER_BYTE_ARRAY: return list(message.byte_array_value, from_byte);
    case PARAMETER_BOOL_ARRAY: return list(message.bool_array_value, from_bool);
    case PARAMETER_INTEGER_ARRAY: return list(message.integer_array_value, from_integer);
    case PARAMETER_DOUBLE_ARRAY: return list(message.double_array_value, from_double);
    case PARAMETER_STRING_ARRAY: return list(message.string_array_value, quoted);
    default: return "not set";
  }
}

rcl_interfaces::msg::Parameter Parameter::to_parameter_msg() const
{
  rcl_interfaces::msg::Parameter message;
  message.name = name_;
  message.value = value_.to_value_msg();
  return message;
}

void Parameter::require(ParameterType type) const
{
  if (get_type() != type) {
    throw exceptions::InvalidParameterTypeException(
            name_, ParameterTypeException(type, get_type()).what());
  }
}

std::string _to_json_dict_entry(const Parameter & parameter)
{
  return quoted(parameter.get_name()) + ": " + std::to_string(parameter);
}

std::ostream & operator<<(std::ostream & os, const Parameter & parameter)
{
  return os << std::to_string(parameter);
}

std::ostream & operator<<(std::ostream & os, const std::vector<Parameter> & parameters)
{
  return os << std::to_string(parameters);
}

}  // namespace rclcpp

namespace std
{

string to_string(const rclcpp::Parameter & parameter)
{
  using rclcpp::quoted;
  return "{\"name\": " + quoted(parameter.get_name()) + ", \"type\": " +
         quoted(parameter.get_type_name()) + ", \"value\": " +
         quoted(parameter.value_to_string()) + "}";
}

string to_string(const vector<rclcpp::Parameter> & parameters)
{
  string text = "{";
  for (const auto & parameter : parameters) {
    text += (text.size() > 1 ? ", " : "") + rclcpp::_to_json_dict_entry(parameter);
  }
  return text + "}";
}

}  // namespace std
