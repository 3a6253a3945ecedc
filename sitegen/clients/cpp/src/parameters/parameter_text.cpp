#include "rclcpp/detail/parameter_text.hpp"

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace rclcpp
{
namespace detail
{

namespace
{

std::string trim(const std::string & text)
{
  const auto begin = text.find_first_not_of(" \t\n");
  if (begin == std::string::npos) {return "";}
  return text.substr(begin, text.find_last_not_of(" \t\n") - begin + 1);
}

bool is_one_of(const std::string & text, std::initializer_list<const char *> words)
{
  for (const char * word : words) {
    if (text == word) {return true;}
  }
  return false;
}

/// The value of a quoted YAML scalar.
std::string unquote(const std::string & text)
{
  std::string result;
  const char quote = text[0];
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    const bool escaped = quote == '"' ? text[i] == '\\' : text[i] == '\'' && text[i + 1] == '\'';
    if (escaped && i + 2 < text.size()) {++i;}
    const char c = text[i];
    result += quote == '"' && escaped && c == 'n' ? '\n' : quote == '"' && escaped && c == 't' ?
      '\t' : c;
  }
  return result;
}

std::vector<std::string> split(const std::string & text)
{
  std::vector<std::string> parts(1);
  char quote = 0;
  for (const char c : text) {
    if (quote) {
      quote = c == quote ? 0 : quote;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == ',') {
      parts.emplace_back();
      continue;
    }
    parts.back() += c;
  }
  for (auto & part : parts) {part = trim(part);}
  if (parts.back().empty()) {parts.pop_back();}  // an empty list, or a trailing comma
  return parts;
}

ParameterValue parse_one(const std::string & text)
{
  const bool is_quoted = text.size() > 1 && (text[0] == '"' || text[0] == '\'') &&
    text.back() == text[0];
  return is_quoted ? ParameterValue(unquote(text)) : parse_scalar(text);
}

template<class T>
ParameterValue vector_of(const std::vector<ParameterValue> & values)
{
  std::vector<T> result;
  for (const auto & value : values) {result.push_back(value.get<T>());}
  return ParameterValue(result);
}

ParameterValue parse_list(const std::string & text)
{
  std::vector<ParameterValue> values;
  for (const auto & part : split(text)) {values.push_back(parse_one(part));}
  try {
    return array_of(values);
  } catch (const ParameterTypeException &) {
    throw std::invalid_argument("Sequence should be of same type: [" + text + "]");
  }
}

}  // namespace

ParameterValue array_of(const std::vector<ParameterValue> & values)
{
  if (values.empty()) {return ParameterValue();}
  switch (values[0].get_type()) {
    case PARAMETER_BOOL: return vector_of<bool>(values);
    case PARAMETER_INTEGER: return vector_of<std::int64_t>(values);
    case PARAMETER_DOUBLE: return vector_of<double>(values);
    default: return vector_of<std::string>(values);
  }
}

ParameterValue parse_scalar(const std::string & text)
{
  if (is_one_of(text, {"Y", "y", "yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON"})) {
    return ParameterValue(true);
  }
  if (is_one_of(
      text, {"N", "n", "no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF"}))
  {
    return ParameterValue(false);
  }
  char * end;
  errno = 0;
  const long long integer = std::strtoll(text.c_str(), &end, 0);
  if (!text.empty() && !*end && !errno) {return ParameterValue(std::int64_t{integer});}
  if (is_one_of(text, {".nan", ".NaN", ".NAN"})) {
    return ParameterValue(std::numeric_limits<double>::quiet_NaN());
  }
  if (is_one_of(text, {".inf", "+.inf", ".Inf", ".INF"})) {return ParameterValue(HUGE_VAL);}
  if (is_one_of(text, {"-.inf", "-.Inf", "-.INF"})) {return ParameterValue(-HUGE_VAL);}
  const bool number = text.find_first_not_of("0123456789+-.eE") == std::string::npos;
  const double value = std::strtod(text.c_str(), &end);
  if (number && !text.empty() && !*end) {return ParameterValue(value);}
  return ParameterValue(text);
}

ParameterValue parse_parameter(const std::string & text)
{
  const std::string value = trim(text);
  if (!value.empty() && value[0] == '[' && value.back() == ']') {
    return parse_list(value.substr(1, value.size() - 2));
  }
  if (!value.empty() && (value[0] == '{' || value[0] == '[')) {
    throw std::invalid_argument("Couldn't parse parameter value: '" + text + "'");
  }
  return parse_one(value);
}

}  // namespace detail
}  // namespace rclcpp
