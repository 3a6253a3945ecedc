#include "rclcpp/logging.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <map>

#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/detail/host.h"
#include "rclcpp/detail/rosout.hpp"

namespace rclcpp
{

namespace
{

std::map<std::string, int> & set_levels()
{
  static auto * levels = new std::map<std::string, int>;
  return *levels;
}

/// The level of `name` in `levels`, 0 if none is set.
int level_of(const std::map<std::string, int> & levels, const std::string & name)
{
  const auto found = levels.find(name);
  return found == levels.end() ? 0 : found->second;
}

}  // namespace

Logger::Level detail::own_level(const Logger & logger)
{
  const std::string name = logger.get_name();
  int level = level_of(set_levels(), name);
  if (!level) {
    level = level_of(contexts::get_global_default_context()->arguments().log_levels, name);
  }
  return Logger::Level(level);
}

void Logger::set_level(Level level) {set_levels()[name_] = static_cast<int>(level);}

Logger::Level Logger::get_effective_level() const
{
  std::string name = name_;
  while (true) {
    const auto level = detail::own_level(Logger(name));
    if (level != Level::Unset) {return level;}
    if (name.empty()) {return Level::Info;}
    const auto dot = name.rfind('.');
    name.erase(dot == std::string::npos ? 0 : dot);
  }
}

namespace detail
{

bool log_enabled(Logger::Level level, const Logger & logger)
{
  return level >= logger.get_effective_level();
}

void log(Logger::Level level, const Logger & logger, const std::string & text)
{
  const auto severity = static_cast<int>(level);
  const double stamp = now();
  ros_log(severity, logger.get_name(), text.c_str(), stamp);
  publish_rosout(severity, logger.get_name(), text, stamp);
}

namespace
{

/// One conversion of a format string: "%-8.3lf" has the spec "%-8.3" and the letter 'f'.
struct Conversion
{
  std::string spec;
  char letter;
  const char * end;
};

template<class Value>
void print(std::string & out, const std::string & spec, Value value)
{
  char buffer[128];
  const int size = std::snprintf(buffer, sizeof(buffer), spec.c_str(), value);
  if (size < static_cast<int>(sizeof(buffer))) {
    out.append(buffer, static_cast<std::size_t>(std::max(size, 0)));
    return;
  }
  std::string large(static_cast<std::size_t>(size) + 1, '\0');
  std::snprintf(large.data(), large.size(), spec.c_str(), value);
  out.append(large, 0, static_cast<std::size_t>(size));
}

/// The bits of `argument` as its own type has them, for conversions that are unsigned.
std::uint64_t unsigned_bits(const FormatArgument & argument)
{
  const auto bits = static_cast<std::uint64_t>(argument.integer);
  return argument.size < 8 ? bits & ((std::uint64_t{1} << argument.size * 8) - 1) : bits;
}

void print_argument(std::string & out, const Conversion & to, const FormatArgument & argument)
{
  using Kind = FormatArgument::Kind;
  const bool number = argument.kind == Kind::kFloat;
  if (std::strchr("fFeEgGaA", to.letter)) {
    const double value = number ? argument.number : static_cast<double>(argument.integer);
    print(out, to.spec + to.letter, value);
  } else if (to.letter == 's') {
    const auto text = static_cast<const char *>(argument.pointer);
    const bool string = argument.kind == Kind::kString;
    print(out, to.spec + 's', string ? (text ? text : "(null)") : "(not a string)");
  } else if (to.letter == 'p') {
    print(out, to.spec + 'p', argument.pointer);
  } else if (to.letter == 'c') {
    print(out, to.spec + 'c', static_cast<int>(argument.integer));
  } else if (std::strchr("uxXo", to.letter)) {
    print(out, to.spec + "ll" + to.letter, unsigned_bits(argument));
  } else {
    const auto value = number ? static_cast<std::int64_t>(argument.number) : argument.integer;
    print(out, to.spec + "lld", value);
  }
}

}  // namespace

std::string format(const char * text, const FormatArgument * arguments, std::size_t count)
{
  std::string out;
  std::size_t next = 0;
  const auto integer = [&]() {
      return next < count ? std::to_string(arguments[next++].integer) : std::string("0");
    };
  while (const char * percent = std::strchr(text, '%')) {
    out.append(text, percent);
    Conversion to{"%", '\0', percent + 1};
    for (; *to.end && std::strchr("-+ #0123456789.*", *to.end); ++to.end) {
      to.spec += *to.end == '*' ? integer() : std::string(1, *to.end);
    }
    while (*to.end && std::strchr("hlLqjzt", *to.end)) {++to.end;}
    to.letter = *to.end;
    if (!to.letter) {return out;}
    if (to.letter == '%') {
      out += '%';
    } else if (next < count) {
      print_argument(out, to, arguments[next++]);
    }
    text = to.end + 1;
  }
  return out + text;
}

}  // namespace detail
}  // namespace rclcpp
