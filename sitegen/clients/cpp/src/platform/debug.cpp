// Linked into programs of `sitegen build --debug`: the origin of exceptions, and the compiler's checks.
#include <cstring>
#include <exception>
#include <typeinfo>

#include "rclcpp/detail/host.h"

namespace
{

/// End the program with a message; the page adds the location.
[[noreturn]] void fault(const char * text)
{
  ros_fail(text);
  __builtin_trap();
}

}  // namespace

// The linker replaces the functions of libc++abi and of the host with these.
extern "C" {

[[noreturn]] void __real___cxa_throw(void * exception, std::type_info * type, void (* destroy)(void *));
void __real_ros_fail(const char * text);

[[noreturn]] void __wrap___cxa_throw(
  void * exception, std::type_info * type, void (* destroy)(void *))
{
  ros_thrown(exception);
  __real___cxa_throw(exception, type, destroy);
}

void __wrap_ros_fail(const char * text)
{
  const auto exception = std::current_exception();
  void * thrown;
  // A reference to the exception; the standard has no function for its address.
  static_assert(sizeof exception == sizeof thrown);
  std::memcpy(&thrown, static_cast<const void *>(&exception), sizeof thrown);
  ros_blame(thrown);
  __real_ros_fail(text);
}

// Called by code that the compiler inserts where a check fails: see cmake/engine.cmake.
[[noreturn]] void __ubsan_handle_type_mismatch_minimal_abort() {fault("a null pointer was used");}
[[noreturn]] void __ubsan_handle_out_of_bounds_minimal_abort()
{
  fault("an index was outside of its array");
}
[[noreturn]] void __ubsan_handle_divrem_overflow_minimal_abort() {fault("division by zero");}
[[noreturn]] void __ubsan_handle_missing_return_minimal()
{
  fault("a function ended without its return value");
}

}  // extern "C"
