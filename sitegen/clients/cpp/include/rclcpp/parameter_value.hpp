#pragma once

#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "rcl_interfaces/msg/parameter_type.hpp"
#include "rcl_interfaces/msg/parameter_value.hpp"

namespace rclcpp
{

enum ParameterType : std::uint8_t
{
  PARAMETER_NOT_SET = rcl_interfaces::msg::ParameterType::PARAMETER_NOT_SET,
  PARAMETER_BOOL = rcl_interfaces::msg::ParameterType::PARAMETER_BOOL,
  PARAMETER_INTEGER = rcl_interfaces::msg::ParameterType::PARAMETER_INTEGER,
  PARAMETER_DOUBLE = rcl_interfaces::msg::ParameterType::PARAMETER_DOUBLE,
  PARAMETER_STRING = rcl_interfaces::msg::ParameterType::PARAMETER_STRING,
  PARAMETER_BYTE_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_BYTE_ARRAY,
  PARAMETER_BOOL_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_BOOL_ARRAY,
  PARAMETER_INTEGER_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_INTEGER_ARRAY,
  PARAMETER_DOUBLE_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_DOUBLE_ARRAY,
  PARAMETER_STRING_ARRAY = rcl_interfaces::msg::ParameterType::PARAMETER_STRING_ARRAY,
};

std::string to_string(ParameterType type);
std::ostream & operator<<(std::ostream & os, ParameterType type);

/// The value is of another type.
class ParameterTypeException : public std::runtime_error
{
public:
  ParameterTypeException(ParameterType expected, ParameterType actual);
};

class ParameterValue
{
public:
  ParameterValue() = default;
  explicit ParameterValue(const rcl_interfaces::msg::ParameterValue & value)
  : value_(value) {}
  explicit ParameterValue(bool value)
  {
    value_.bool_value = value;
    value_.type = PARAMETER_BOOL;
  }
  explicit ParameterValue(int value)
  : ParameterValue(std::int64_t{value}) {}
  explicit ParameterValue(std::int64_t value)
  {
    value_.integer_value = value;
    value_.type = PARAMETER_INTEGER;
  }
  // Here int64_t is long long, and long is another type; on 64-bit Linux it is the other way round.
  template<
    class T, std::enable_if_t<
      std::is_integral_v<T> && !std::is_same_v<T, bool> && !std::is_same_v<T, int> &&
      !std::is_same_v<T, std::int64_t>, int> = 0>
  explicit ParameterValue(T value)
  : ParameterValue(static_cast<std::int64_t>(value)) {}
  explicit ParameterValue(float value)
  : ParameterValue(static_cast<double>(value)) {}
  explicit ParameterValue(double value)
  {
    value_.double_value = value;
    value_.type = PARAMETER_DOUBLE;
  }
  explicit ParameterValue(std::string value)
  {
    value_.string_value = std::move(value);
    value_.type = PARAMETER_STRING;
  }
  explicit ParameterValue(const char * value)
  : ParameterValue(std::string(value)) {}
  explicit ParameterValue(const std::vector<std::uint8_t> & value)
  {
    value_.byte_array_value = value;
    value_.type = PARAMETER_BYTE_ARRAY;
  }
  explicit ParameterValue(const std::vector<bool> & value)
  {
    value_.bool_array_value = value;
    value_.type = PARAMETER_BOOL_ARRAY;
  }
  explicit ParameterValue(const std::vector<int> & value)
  : ParameterValue(std::vector<std::int64_t>(value.begin(), value.end())) {}
  explicit ParameterValue(const std::vector<std::int64_t> & value)
  {
    value_.integer_array_value = value;
    value_.type = PARAMETER_INTEGER_ARRAY;
  }
  explicit ParameterValue(const std::vector<float> & value)
  : ParameterValue(std::vector<double>(value.begin(), value.end())) {}
  explicit ParameterValue(const std::vector<double> & value)
  {
    value_.double_array_value = value;
    value_.type = PARAMETER_DOUBLE_ARRAY;
  }
  explicit ParameterValue(const std::vector<std::string> & value)
  {
    value_.string_array_value = value;
    value_.type = PARAMETER_STRING_ARRAY;
  }

  ParameterType get_type() const {return static_cast<ParameterType>(value_.type);}
  rcl_interfaces::msg::ParameterValue to_value_msg() const {return value_;}
  bool operator==(const ParameterValue & other) const {return value_ == other.value_;}
  bool operator!=(const ParameterValue & other) const {return value_ != other.value_;}

  /// The value as `type`. Throws ParameterTypeException if it is of another.
  template<ParameterType type>
  decltype(auto) get() const
  {
    require(type);
    if constexpr (type == PARAMETER_BOOL) {
      return (value_.bool_value);
    } else if constexpr (type == PARAMETER_INTEGER) {
      return (value_.integer_value);
    } else if constexpr (type == PARAMETER_DOUBLE) {
      return (value_.double_value);
    } else if constexpr (type == PARAMETER_STRING) {
      return (value_.string_value);
    } else if constexpr (type == PARAMETER_BYTE_ARRAY) {
      return (value_.byte_array_value);
    } else if constexpr (type == PARAMETER_BOOL_ARRAY) {
      return (value_.bool_array_value);
    } else if constexpr (type == PARAMETER_INTEGER_ARRAY) {
      return (value_.integer_array_value);
    } else if constexpr (type == PARAMETER_DOUBLE_ARRAY) {
      return (value_.double_array_value);
    } else {
      return (value_.string_array_value);
    }
  }

  /// The value as a C++ type; other integers, floats and vectors of them are converted.
  template<class T>
  decltype(auto) get() const
  {
    constexpr ParameterType type = type_of<T>();
    using Exact = std::decay_t<decltype(get<type>())>;
    if constexpr (std::is_same_v<T, Exact>) {
      return get<type>();
    } else if constexpr (is_vector<T>::value) {
      const auto & values = get<type>();
      return T(values.begin(), values.end());
    } else {
      return static_cast<T>(get<type>());
    }
  }

  template<class T>
  static constexpr ParameterType type_of()
  {
    using Vector = is_vector<T>;
    if constexpr (std::is_same_v<T, bool>) {
      return PARAMETER_BOOL;
    } else if constexpr (std::is_integral_v<T>) {
      return PARAMETER_INTEGER;
    } else if constexpr (std::is_floating_point_v<T>) {
      return PARAMETER_DOUBLE;
    } else if constexpr (std::is_convertible_v<T, std::string>) {
      return PARAMETER_STRING;
    } else {
      using Element = typename Vector::Element;
      static_assert(
        Vector::value,
        "a parameter is a bool, a number, a std::string or a std::vector of one of these");
      if constexpr (std::is_same_v<Element, std::uint8_t>) {
        return PARAMETER_BYTE_ARRAY;
      } else if constexpr (std::is_same_v<Element, bool>) {
        return PARAMETER_BOOL_ARRAY;
      } else if constexpr (std::is_integral_v<Element>) {
        return PARAMETER_INTEGER_ARRAY;
      } else if constexpr (std::is_floating_point_v<Element>) {
        return PARAMETER_DOUBLE_ARRAY;
      } else {
        return PARAMETER_STRING_ARRAY;
      }
    }
  }

private:
  template<class T>
  struct is_vector : std::false_type {using Element = void;};
  template<class T, class A>
  struct is_vector<std::vector<T, A>> : std::true_type {using Element = T;};

  void require(ParameterType type) const;

  rcl_interfaces::msg::ParameterValue value_;
};

/// As YAML writes it.
std::string to_string(const ParameterValue & value);

}  // namespace rclcpp
