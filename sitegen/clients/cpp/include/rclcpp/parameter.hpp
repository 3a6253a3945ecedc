#pragma once

#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "rcl_interfaces/msg/parameter.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/parameter_value.hpp"

namespace rclcpp
{

/// A parameter: a name with a value.
class Parameter
{
public:
  Parameter() = default;
  explicit Parameter(std::string name)
  : name_(std::move(name)) {}
  Parameter(std::string name, const ParameterValue & value)
  : name_(std::move(name)), value_(value) {}
  template<class ValueT>
  Parameter(const std::string & name, ValueT value)
  : Parameter(name, ParameterValue(value)) {}

  static Parameter from_parameter_msg(const rcl_interfaces::msg::Parameter & parameter)
  {
    return Parameter(parameter.name, ParameterValue(parameter.value));
  }
  rcl_interfaces::msg::Parameter to_parameter_msg() const;

  const std::string & get_name() const {return name_;}
  ParameterType get_type() const {return value_.get_type();}
  std::string get_type_name() const {return to_string(get_type());}
  rcl_interfaces::msg::ParameterValue get_value_message() const {return value_.to_value_msg();}
  const ParameterValue & get_parameter_value() const {return value_;}
  std::string value_to_string() const {return to_string(value_);}
  bool operator==(const Parameter & other) const
  {
    return name_ == other.name_ && value_ == other.value_;
  }
  bool operator!=(const Parameter & other) const {return !(*this == other);}

  /// These throw InvalidParameterTypeException if it is of another type.
  template<ParameterType type>
  decltype(auto) get_value() const
  {
    require(type);
    return value_.get<type>();
  }
  template<class T>
  decltype(auto) get_value() const
  {
    if constexpr (std::is_same_v<T, Parameter>) {
      return (*this);
    } else if constexpr (std::is_same_v<T, ParameterValue>) {
      return (value_);
    } else {
      require(ParameterValue::type_of<T>());
      return value_.get<T>();
    }
  }
  bool as_bool() const {return get_value<PARAMETER_BOOL>();}
  std::int64_t as_int() const {return get_value<PARAMETER_INTEGER>();}
  double as_double() const {return get_value<PARAMETER_DOUBLE>();}
  const std::string & as_string() const {return get_value<PARAMETER_STRING>();}
  const std::vector<std::uint8_t> & as_byte_array() const
  {
    return get_value<PARAMETER_BYTE_ARRAY>();
  }
  const std::vector<bool> & as_bool_array() const {return get_value<PARAMETER_BOOL_ARRAY>();}
  const std::vector<std::int64_t> & as_integer_array() const
  {
    return get_value<PARAMETER_INTEGER_ARRAY>();
  }
  const std::vector<double> & as_double_array() const
  {
    return get_value<PARAMETER_DOUBLE_ARRAY>();
  }
  const std::vector<std::string> & as_string_array() const
  {
    return get_value<PARAMETER_STRING_ARRAY>();
  }

private:
  void require(ParameterType type) const;

  std::string name_;
  ParameterValue value_;
};

std::ostream & operator<<(std::ostream & os, const Parameter & parameter);
std::ostream & operator<<(std::ostream & os, const std::vector<Parameter> & parameters);
/// The name and to_string() of `parameter`, as an entry of a mapping in JSON.
std::string _to_json_dict_entry(const Parameter & parameter);

}  // namespace rclcpp

namespace std
{

/// As a mapping in JSON.
string to_string(const rclcpp::Parameter & parameter);
string to_string(const vector<rclcpp::Parameter> & parameters);

}  // namespace std
