#include "rclcpp/detail/parameter_text.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "yaml_text.hpp"

namespace rclcpp
{
namespace detail
{

namespace
{

/// Whether `text` is one of `words`, which have spaces between them.
bool is_one_of(const std::string & text, const char * words)
{
  while (*words) {
    const std::size_t size = std::strcspn(words, " ");
    if (size == text.size() && std::memcmp(words, text.data(), size) == 0) {return true;}
    words += size + (words[size] != 0);
  }
  return false;
}

/// Read a scalar, which ends at one of `ends` if it has no quotes.
ParameterValue scalar(YamlText & text, const char * ends)
{
  const bool is_text = text.look() == '!' && text.word() == "!!str";
  text.skip_blanks();
  if (text.looks_at_one_of("\"'")) {return ParameterValue(text.quoted());}
  const std::string plain = text.plain(ends);
  if (plain.empty()) {text.fail();}
  return is_text ? ParameterValue(plain) : parse_scalar(plain);
}

template<class T>
ParameterValue vector_of(const std::vector<ParameterValue> & values)
{
  std::vector<T> result;
  for (const auto & value : values) {result.push_back(value.get<T>());}
  return ParameterValue(result);
}

ParameterValue list(YamlText & text)
{
  std::vector<ParameterValue> values;
  for (text.skip(), text.seek(); text.look() != ']'; text.seek()) {
    values.push_back(scalar(text, ",[]{}"));
    if (values.back().get_type() != values.front().get_type()) {
      throw std::invalid_argument("Sequence should be of same type");
    }
    text.seek();
    if (text.look() == ',') {
      text.skip();
    } else if (text.look() != ']') {
      text.fail();
    }
  }
  text.skip();
  return array_of(values);
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
  if (is_one_of(text, "Y y yes Yes YES true True TRUE on On ON")) {return ParameterValue(true);}
  if (is_one_of(text, "N n no No NO false False FALSE off Off OFF")) {
    return ParameterValue(false);
  }
  // The C library of Emscripten takes "0x" for a number.
  if (text.empty() || text.back() == 'x' || text.back() == 'X') {return ParameterValue(text);}
  char * end;
  errno = 0;
  const long long integer = std::strtoll(text.c_str(), &end, 0);
  if (!*end && !errno) {return ParameterValue(std::int64_t{integer});}
  const bool is_special = is_one_of(
    text, ".inf +.inf -.inf .Inf +.Inf -.Inf .INF +.INF -.INF .nan .NaN .NAN");
  std::string number = text;
  if (is_special) {number.erase(number.find('.'), 1);}
  errno = 0;
  const double value = std::strtod(number.c_str(), &end);
  if (!*end && !errno) {return ParameterValue(value);}
  return ParameterValue(text);
}

ParameterValue parse_parameter(const std::string & value)
{
  YamlText text(value);
  text.seek();
  const bool is_list = text.look() == '[';
  ParameterValue parsed = is_list ? list(text) : scalar(text, "");
  text.seek();
  if (text.look()) {text.fail();}
  return parsed;
}

}  // namespace detail
}  // namespace rclcpp
