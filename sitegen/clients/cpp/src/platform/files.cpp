// Files of packages, below /ros/share: the page has their names and sizes from the start, and loads
// their contents when a program opens them. A thread that opens one waits while others continue.
#include <fcntl.h>

#include <cerrno>

#include "rclcpp/detail/host.h"
#include "rclcpp/detail/platform.hpp"

namespace
{

/// Wait for the content of a file, if it is one of a package. Returns 0 or a negative error number.
long load(long folder, long path, long flags)
{
  for (;;) {
    const int32_t state = ros_open(
      static_cast<int32_t>(folder), reinterpret_cast<const char *>(path), flags & O_TRUNC);
    if (state <= 0) {return state;}
    if (rclcpp::detail::is_ending()) {return -EIO;}
    rclcpp::detail::wait(-1);
  }
}

}  // namespace

extern "C" {

// The linker replaces the two functions of Emscripten by which the C library opens files with these.
// Their mode is an optional argument, which the compiler passes by address.
long __real___syscall_open(long path, long flags, void * mode);

long __wrap___syscall_open(long path, long flags, void * mode)
{
  const long error = load(AT_FDCWD, path, flags);
  return error ? error : __real___syscall_open(path, flags, mode);
}

long __real___syscall_openat(long folder, long path, long flags, void * mode);

long __wrap___syscall_openat(long folder, long path, long flags, void * mode)
{
  const long error = load(folder, path, flags);
  return error ? error : __real___syscall_openat(folder, path, flags, mode);
}

}
