// The functions of rcutils that programs call; the headers are upstream's.
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "rclcpp/detail/platform.hpp"
#include "rclcpp/logging.hpp"
#include "rcutils/allocator.h"
#include "rcutils/cmdline_parser.h"
#include "rcutils/env.h"
#include "rcutils/error_handling.h"
#include "rcutils/logging.h"
#include "rcutils/time.h"
#include "rcutils/types/uint8_array.h"

namespace
{

rcutils_error_string_t error = {};  // empty: not set

rclcpp::Logger logger(const char * name) {return rclcpp::Logger(name ? name : "");}

void log(int severity, const char * name, const char * format, va_list arguments)
{
  va_list again;
  va_copy(again, arguments);
  const int size = std::vsnprintf(nullptr, 0, format, again);
  va_end(again);
  std::string text(static_cast<std::size_t>(size < 0 ? 0 : size), '\0');
  std::vsnprintf(text.data(), text.size() + 1, format, arguments);
  rclcpp::detail::log(rclcpp::Logger::Level(severity), logger(name), text);
}

}  // namespace

extern "C" {

bool g_rcutils_logging_initialized = true;

rcutils_ret_t rcutils_logging_initialize(void) {return RCUTILS_RET_OK;}

rcutils_ret_t rcutils_logging_initialize_with_allocator(rcutils_allocator_t)
{
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_logging_shutdown(void) {return RCUTILS_RET_OK;}

rcutils_allocator_t rcutils_get_default_allocator(void)
{
  return {
    [](std::size_t size, void *) {return std::malloc(size);},
    [](void * pointer, void *) {std::free(pointer);},
    [](void * pointer, std::size_t size, void *) {return std::realloc(pointer, size);},
    [](std::size_t count, std::size_t size, void *) {return std::calloc(count, size);}, nullptr};
}

bool rcutils_allocator_is_valid(const rcutils_allocator_t * allocator)
{
  return allocator && allocator->allocate && allocator->deallocate && allocator->zero_allocate &&
         allocator->reallocate;
}

rcutils_uint8_array_t rcutils_get_zero_initialized_uint8_array(void) {return {};}

rcutils_ret_t rcutils_uint8_array_init(
  rcutils_uint8_array_t * array, std::size_t capacity, const rcutils_allocator_t * allocator)
{
  if (!array || !allocator) {return RCUTILS_RET_INVALID_ARGUMENT;}
  *array = {nullptr, 0, 0, *allocator};
  return capacity ? rcutils_uint8_array_resize(array, capacity) : RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_uint8_array_fini(rcutils_uint8_array_t * array)
{
  if (!array) {return RCUTILS_RET_INVALID_ARGUMENT;}
  if (array->buffer) {array->allocator.deallocate(array->buffer, array->allocator.state);}
  array->buffer = nullptr;
  array->buffer_length = array->buffer_capacity = 0;
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_uint8_array_resize(rcutils_uint8_array_t * array, std::size_t size)
{
  if (!array || size == 0 || !array->allocator.reallocate) {return RCUTILS_RET_INVALID_ARGUMENT;}
  void * buffer = array->allocator.reallocate(array->buffer, size, array->allocator.state);
  if (!buffer) {return RCUTILS_RET_BAD_ALLOC;}
  array->buffer = static_cast<std::uint8_t *>(buffer);
  array->buffer_capacity = size;
  if (array->buffer_length > size) {array->buffer_length = size;}
  return RCUTILS_RET_OK;
}

void rcutils_set_error_state(const char * text, const char * file, std::size_t line)
{
  std::snprintf(error.str, sizeof(error.str), "%s, at %s:%zu", text, file, line);
}

bool rcutils_error_is_set(void) {return error.str[0];}

rcutils_error_string_t rcutils_get_error_string(void)
{
  return error.str[0] ? error : rcutils_error_string_t{"error not set"};
}

void rcutils_reset_error(void) {error = {};}

bool rcutils_logging_logger_is_enabled_for(const char * name, int severity)
{
  return rclcpp::detail::log_enabled(rclcpp::Logger::Level(severity), logger(name));
}

int rcutils_logging_get_logger_effective_level(const char * name)
{
  return static_cast<int>(logger(name).get_effective_level());
}

rcutils_ret_t rcutils_logging_set_logger_level(const char * name, int level)
{
  logger(name).set_level(rclcpp::Logger::Level(level));
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_logging_severity_level_from_string(
  const char * name, rcutils_allocator_t, int * severity)
{
  static const char * const kNames[] = {"UNSET", "DEBUG", "INFO", "WARN", "ERROR", "FATAL"};
  for (int i = 0; i < 6; ++i) {
    if (strcasecmp(name, kNames[i]) == 0) {
      *severity = i * 10;
      return RCUTILS_RET_OK;
    }
  }
  return RCUTILS_RET_LOGGING_SEVERITY_STRING_INVALID;
}

void rcutils_log(
  const rcutils_log_location_t *, int severity, const char * name, const char * format, ...)
{
  if (!rcutils_logging_logger_is_enabled_for(name, severity)) {return;}
  va_list arguments;
  va_start(arguments, format);
  log(severity, name, format, arguments);
  va_end(arguments);
}

void rcutils_log_internal(
  const rcutils_log_location_t *, int severity, const char * name, const char * format, ...)
{
  va_list arguments;
  va_start(arguments, format);
  log(severity, name, format, arguments);
  va_end(arguments);
}

bool rcutils_cli_option_exist(char ** begin, char ** end, const char * option)
{
  for (char ** word = begin; word != end; ++word) {
    if (std::strcmp(*word, option) == 0) {return true;}
  }
  return false;
}

char * rcutils_cli_get_option(char ** begin, char ** end, const char * option)
{
  for (char ** word = begin; word != end; ++word) {
    if (std::strcmp(*word, option) == 0) {return word + 1 == end ? nullptr : word[1];}
  }
  return nullptr;
}

rcutils_ret_t rcutils_system_time_now(rcutils_time_point_value_t * now)
{
  *now = rclcpp::detail::nanoseconds(rclcpp::detail::now());
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_steady_time_now(rcutils_time_point_value_t * now)
{
  return rcutils_system_time_now(now);  // never goes backwards
}

const char * rcutils_get_env(const char * name, const char ** value)
{
  if (!name || !value) {return "argument is null";}
  const char * found = std::getenv(name);
  *value = found ? found : "";
  return nullptr;
}

}  // extern "C"
