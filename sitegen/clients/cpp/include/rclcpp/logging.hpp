// The logging macros. Each argument is printed according to its type, so that "%ld" with an int64_t
// and "%d" with a size_t also work here, where these types have other sizes.
#pragma once

#include <cstdint>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>

#include "rclcpp/logger.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{
namespace detail
{

/// One argument of a format string.
struct FormatArgument
{
  enum class Kind : std::uint8_t {kInteger, kFloat, kString, kPointer};

  template<class T>
  FormatArgument(const T & value)  // NOLINT: made from any argument
  {
    using Value = std::decay_t<T>;
    if constexpr (std::is_enum_v<Value> || std::is_integral_v<Value>) {
      kind = Kind::kInteger;
      size = sizeof(Value);
      integer = static_cast<std::int64_t>(value);
    } else if constexpr (std::is_floating_point_v<Value>) {
      kind = Kind::kFloat;
      number = value;
    } else if constexpr (std::is_convertible_v<const T &, const char *>) {
      kind = Kind::kString;
      pointer = static_cast<const char *>(value);
    } else {
      static_assert(
        std::is_pointer_v<Value> || std::is_null_pointer_v<Value>,
        "an argument of a logging macro must be a number, a C string or a pointer: "
        "a std::string wants .c_str()");
      kind = Kind::kPointer;
      pointer = reinterpret_cast<const void *>(value);
    }
  }

  Kind kind;
  std::uint8_t size = 8;
  union
  {
    std::int64_t integer;
    double number;
    const void * pointer;
  };
};

/// Print like printf.
std::string format(const char * text, const FormatArgument * arguments, std::size_t count);

/// The level set for this logger itself.
Logger::Level own_level(const Logger & logger);
bool log_enabled(Logger::Level level, const Logger & logger);
void log(Logger::Level level, const Logger & logger, const std::string & text);

template<class ... Args>
std::string format(const char * text, const Args & ... args)
{
  const FormatArgument arguments[] = {FormatArgument(args)..., FormatArgument(0)};
  return format(text, arguments, sizeof...(Args));
}

template<class ... Args>
std::string format(const std::string & text, const Args & ... args)
{
  return format(text.c_str(), args ...);
}

/// Whether `milliseconds` have passed since `last`, which is then set to now; its initial value is
/// -1.
template<class ClockT>
bool throttle_passed(ClockT & clock, std::int64_t milliseconds, std::int64_t & last)
{
  const std::int64_t now = clock.now().nanoseconds();
  if (last >= 0 && now - last < milliseconds * 1000000) {return false;}
  last = now;
  return true;
}

}  // namespace detail
}  // namespace rclcpp

#define RCLCPP_DETAIL_LOG_IF(condition, level, logger, ...) \
  do { \
    const ::rclcpp::Logger & rclcpp_logger = logger; \
    if (::rclcpp::detail::log_enabled(::rclcpp::Logger::Level::level, rclcpp_logger) && \
      (condition)) \
    { \
      ::rclcpp::detail::log( \
        ::rclcpp::Logger::Level::level, rclcpp_logger, ::rclcpp::detail::format(__VA_ARGS__)); \
    } \
  } while (0)

#define RCLCPP_DETAIL_STREAM_IF(condition, level, logger, stream_arg) \
  do { \
    const ::rclcpp::Logger & rclcpp_logger = logger; \
    if (::rclcpp::detail::log_enabled(::rclcpp::Logger::Level::level, rclcpp_logger) && \
      (condition)) \
    { \
      ::std::stringstream rclcpp_stream; \
      rclcpp_stream << stream_arg; \
      ::rclcpp::detail::log(::rclcpp::Logger::Level::level, rclcpp_logger, rclcpp_stream.str()); \
    } \
  } while (0)

// The state of conditions, one for each location in the source.
#define RCLCPP_DETAIL_ONCE ([]() {static bool first = true; return std::exchange(first, false);}())
#define RCLCPP_DETAIL_SKIPFIRST \
  ([]() {static bool first = true; return !std::exchange(first, false);}())
#define RCLCPP_DETAIL_THROTTLE(clock, duration) \
  ([&]() { \
    static std::int64_t last = -1; \
    return ::rclcpp::detail::throttle_passed(clock, duration, last); \
  }())

#define RCLCPP_DEBUG(logger, ...) RCLCPP_DETAIL_LOG_IF(true, Debug, logger, __VA_ARGS__)
#define RCLCPP_DEBUG_ONCE(logger, ...) \
  RCLCPP_DETAIL_LOG_IF(RCLCPP_DETAIL_ONCE, Debug, logger, __VA_ARGS__)
#define RCLCPP_DEBUG_EXPRESSION(logger, expression, ...) \
  RCLCPP_DETAIL_LOG_IF(expression, Debug, logger, __VA_ARGS__)
#define RCLCPP_DEBUG_FUNCTION(logger, function, ...) \
  RCLCPP_DETAIL_LOG_IF((*function)(), Debug, logger, __VA_ARGS__)
#define RCLCPP_DEBUG_SKIPFIRST(logger, ...) \
  RCLCPP_DETAIL_LOG_IF(RCLCPP_DETAIL_SKIPFIRST, Debug, logger, __VA_ARGS__)
#define RCLCPP_DEBUG_THROTTLE(logger, clock, duration, ...) \
  RCLCPP_DETAIL_LOG_IF(RCLCPP_DETAIL_THROTTLE(clock, duration), Debug, logger, __VA_ARGS__)
#define RCLCPP_DEBUG_SKIPFIRST_THROTTLE(logger, clock, duration, ...) \
  RCLCPP_DETAIL_LOG_IF( \
    RCLCPP_DETAIL_SKIPFIRST && RCLCPP_DETAIL_THROTTLE(clock, duration), Debug, logger, __VA_ARGS__)
#define RCLCPP_DEBUG_STREAM(logger, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(true, Debug, logger, stream_arg)
#define RCLCPP_DEBUG_STREAM_ONCE(logger, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(RCLCPP_DETAIL_ONCE, Debug, logger, stream_arg)
#define RCLCPP_DEBUG_STREAM_EXPRESSION(logger, expression, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(expression, Debug, logger, stream_arg)
#define RCLCPP_DEBUG_STREAM_FUNCTION(logger, function, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF((*function)(), Debug, logger, stream_arg)
#define RCLCPP_DEBUG_STREAM_SKIPFIRST(logger, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(RCLCPP_DETAIL_SKIPFIRST, Debug, logger, stream_arg)
#define RCLCPP_DEBUG_STREAM_THROTTLE(logger, clock, duration, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(RCLCPP_DETAIL_THROTTLE(clock, duration), Debug, logger, stream_arg)
#define RCLCPP_DEBUG_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF( \
    RCLCPP_DETAIL_SKIPFIRST && RCLCPP_DETAIL_THROTTLE(clock, duration), Debug, logger, stream_arg)

#define RCLCPP_INFO(logger, ...) RCLCPP_DETAIL_LOG_IF(true, Info, logger, __VA_ARGS__)
#define RCLCPP_INFO_ONCE(logger, ...) \
  RCLCPP_DETAIL_LOG_IF(RCLCPP_DETAIL_ONCE, Info, logger, __VA_ARGS__)
#define RCLCPP_INFO_EXPRESSION(logger, expression, ...) \
  RCLCPP_DETAIL_LOG_IF(expression, Info, logger, __VA_ARGS__)
#define RCLCPP_INFO_FUNCTION(logger, function, ...) \
  RCLCPP_DETAIL_LOG_IF((*function)(), Info, logger, __VA_ARGS__)
#define RCLCPP_INFO_SKIPFIRST(logger, ...) \
  RCLCPP_DETAIL_LOG_IF(RCLCPP_DETAIL_SKIPFIRST, Info, logger, __VA_ARGS__)
#define RCLCPP_INFO_THROTTLE(logger, clock, duration, ...) \
  RCLCPP_DETAIL_LOG_IF(RCLCPP_DETAIL_THROTTLE(clock, duration), Info, logger, __VA_ARGS__)
#define RCLCPP_INFO_SKIPFIRST_THROTTLE(logger, clock, duration, ...) \
  RCLCPP_DETAIL_LOG_IF( \
    RCLCPP_DETAIL_SKIPFIRST && RCLCPP_DETAIL_THROTTLE(clock, duration), Info, logger, __VA_ARGS__)
#define RCLCPP_INFO_STREAM(logger, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(true, Info, logger, stream_arg)
#define RCLCPP_INFO_STREAM_ONCE(logger, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(RCLCPP_DETAIL_ONCE, Info, logger, stream_arg)
#define RCLCPP_INFO_STREAM_EXPRESSION(logger, expression, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(expression, Info, logger, stream_arg)
#define RCLCPP_INFO_STREAM_FUNCTION(logger, function, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF((*function)(), Info, logger, stream_arg)
#define RCLCPP_INFO_STREAM_SKIPFIRST(logger, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(RCLCPP_DETAIL_SKIPFIRST, Info, logger, stream_arg)
#define RCLCPP_INFO_STREAM_THROTTLE(logger, clock, duration, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(RCLCPP_DETAIL_THROTTLE(clock, duration), Info, logger, stream_arg)
#define RCLCPP_INFO_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF( \
    RCLCPP_DETAIL_SKIPFIRST && RCLCPP_DETAIL_THROTTLE(clock, duration), Info, logger, stream_arg)

#define RCLCPP_WARN(logger, ...) RCLCPP_DETAIL_LOG_IF(true, Warn, logger, __VA_ARGS__)
#define RCLCPP_WARN_ONCE(logger, ...) \
  RCLCPP_DETAIL_LOG_IF(RCLCPP_DETAIL_ONCE, Warn, logger, __VA_ARGS__)
#define RCLCPP_WARN_EXPRESSION(logger, expression, ...) \
  RCLCPP_DETAIL_LOG_IF(expression, Warn, logger, __VA_ARGS__)
#define RCLCPP_WARN_FUNCTION(logger, function, ...) \
  RCLCPP_DETAIL_LOG_IF((*function)(), Warn, logger, __VA_ARGS__)
#define RCLCPP_WARN_SKIPFIRST(logger, ...) \
  RCLCPP_DETAIL_LOG_IF(RCLCPP_DETAIL_SKIPFIRST, Warn, logger, __VA_ARGS__)
#define RCLCPP_WARN_THROTTLE(logger, clock, duration, ...) \
  RCLCPP_DETAIL_LOG_IF(RCLCPP_DETAIL_THROTTLE(clock, duration), Warn, logger, __VA_ARGS__)
#define RCLCPP_WARN_SKIPFIRST_THROTTLE(logger, clock, duration, ...) \
  RCLCPP_DETAIL_LOG_IF( \
    RCLCPP_DETAIL_SKIPFIRST && RCLCPP_DETAIL_THROTTLE(clock, duration), Warn, logger, __VA_ARGS__)
#define RCLCPP_WARN_STREAM(logger, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(true, Warn, logger, stream_arg)
#define RCLCPP_WARN_STREAM_ONCE(logger, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(RCLCPP_DETAIL_ONCE, Warn, logger, stream_arg)
#define RCLCPP_WARN_STREAM_EXPRESSION(logger, expression, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(expression, Warn, logger, stream_arg)
#define RCLCPP_WARN_STREAM_FUNCTION(logger, function, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF((*function)(), Warn, logger, stream_arg)
#define RCLCPP_WARN_STREAM_SKIPFIRST(logger, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(RCLCPP_DETAIL_SKIPFIRST, Warn, logger, stream_arg)
#define RCLCPP_WARN_STREAM_THROTTLE(logger, clock, duration, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(RCLCPP_DETAIL_THROTTLE(clock, duration), Warn, logger, stream_arg)
#define RCLCPP_WARN_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF( \
    RCLCPP_DETAIL_SKIPFIRST && RCLCPP_DETAIL_THROTTLE(clock, duration), Warn, logger, stream_arg)

#define RCLCPP_ERROR(logger, ...) RCLCPP_DETAIL_LOG_IF(true, Error, logger, __VA_ARGS__)
#define RCLCPP_ERROR_ONCE(logger, ...) \
  RCLCPP_DETAIL_LOG_IF(RCLCPP_DETAIL_ONCE, Error, logger, __VA_ARGS__)
#define RCLCPP_ERROR_EXPRESSION(logger, expression, ...) \
  RCLCPP_DETAIL_LOG_IF(expression, Error, logger, __VA_ARGS__)
#define RCLCPP_ERROR_FUNCTION(logger, function, ...) \
  RCLCPP_DETAIL_LOG_IF((*function)(), Error, logger, __VA_ARGS__)
#define RCLCPP_ERROR_SKIPFIRST(logger, ...) \
  RCLCPP_DETAIL_LOG_IF(RCLCPP_DETAIL_SKIPFIRST, Error, logger, __VA_ARGS__)
#define RCLCPP_ERROR_THROTTLE(logger, clock, duration, ...) \
  RCLCPP_DETAIL_LOG_IF(RCLCPP_DETAIL_THROTTLE(clock, duration), Error, logger, __VA_ARGS__)
#define RCLCPP_ERROR_SKIPFIRST_THROTTLE(logger, clock, duration, ...) \
  RCLCPP_DETAIL_LOG_IF( \
    RCLCPP_DETAIL_SKIPFIRST && RCLCPP_DETAIL_THROTTLE(clock, duration), Error, logger, __VA_ARGS__)
#define RCLCPP_ERROR_STREAM(logger, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(true, Error, logger, stream_arg)
#define RCLCPP_ERROR_STREAM_ONCE(logger, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(RCLCPP_DETAIL_ONCE, Error, logger, stream_arg)
#define RCLCPP_ERROR_STREAM_EXPRESSION(logger, expression, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(expression, Error, logger, stream_arg)
#define RCLCPP_ERROR_STREAM_FUNCTION(logger, function, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF((*function)(), Error, logger, stream_arg)
#define RCLCPP_ERROR_STREAM_SKIPFIRST(logger, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(RCLCPP_DETAIL_SKIPFIRST, Error, logger, stream_arg)
#define RCLCPP_ERROR_STREAM_THROTTLE(logger, clock, duration, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(RCLCPP_DETAIL_THROTTLE(clock, duration), Error, logger, stream_arg)
#define RCLCPP_ERROR_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF( \
    RCLCPP_DETAIL_SKIPFIRST && RCLCPP_DETAIL_THROTTLE(clock, duration), Error, logger, stream_arg)

#define RCLCPP_FATAL(logger, ...) RCLCPP_DETAIL_LOG_IF(true, Fatal, logger, __VA_ARGS__)
#define RCLCPP_FATAL_ONCE(logger, ...) \
  RCLCPP_DETAIL_LOG_IF(RCLCPP_DETAIL_ONCE, Fatal, logger, __VA_ARGS__)
#define RCLCPP_FATAL_EXPRESSION(logger, expression, ...) \
  RCLCPP_DETAIL_LOG_IF(expression, Fatal, logger, __VA_ARGS__)
#define RCLCPP_FATAL_FUNCTION(logger, function, ...) \
  RCLCPP_DETAIL_LOG_IF((*function)(), Fatal, logger, __VA_ARGS__)
#define RCLCPP_FATAL_SKIPFIRST(logger, ...) \
  RCLCPP_DETAIL_LOG_IF(RCLCPP_DETAIL_SKIPFIRST, Fatal, logger, __VA_ARGS__)
#define RCLCPP_FATAL_THROTTLE(logger, clock, duration, ...) \
  RCLCPP_DETAIL_LOG_IF(RCLCPP_DETAIL_THROTTLE(clock, duration), Fatal, logger, __VA_ARGS__)
#define RCLCPP_FATAL_SKIPFIRST_THROTTLE(logger, clock, duration, ...) \
  RCLCPP_DETAIL_LOG_IF( \
    RCLCPP_DETAIL_SKIPFIRST && RCLCPP_DETAIL_THROTTLE(clock, duration), Fatal, logger, __VA_ARGS__)
#define RCLCPP_FATAL_STREAM(logger, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(true, Fatal, logger, stream_arg)
#define RCLCPP_FATAL_STREAM_ONCE(logger, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(RCLCPP_DETAIL_ONCE, Fatal, logger, stream_arg)
#define RCLCPP_FATAL_STREAM_EXPRESSION(logger, expression, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(expression, Fatal, logger, stream_arg)
#define RCLCPP_FATAL_STREAM_FUNCTION(logger, function, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF((*function)(), Fatal, logger, stream_arg)
#define RCLCPP_FATAL_STREAM_SKIPFIRST(logger, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(RCLCPP_DETAIL_SKIPFIRST, Fatal, logger, stream_arg)
#define RCLCPP_FATAL_STREAM_THROTTLE(logger, clock, duration, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF(RCLCPP_DETAIL_THROTTLE(clock, duration), Fatal, logger, stream_arg)
#define RCLCPP_FATAL_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, stream_arg) \
  RCLCPP_DETAIL_STREAM_IF( \
    RCLCPP_DETAIL_SKIPFIRST && RCLCPP_DETAIL_THROTTLE(clock, duration), Fatal, logger, stream_arg)
