// Standard input: the text that a visitor types in the console. A thread that reads waits while other
// threads continue.
#include <fcntl.h>
#include <poll.h>
#include <sys/select.h>
#include <sys/uio.h>
#include <termios.h>
#include <unistd.h>
#include <wasi/api.h>

#include <algorithm>
#include <csignal>
#include <cstdarg>
#include <cstdio>

#include "rclcpp/detail/host.h"
#include "rclcpp/detail/platform.hpp"
#include "rclcpp/detail/stacks.hpp"

namespace
{

termios terminal()
{
  termios settings{};
  settings.c_iflag = ICRNL;
  settings.c_lflag = ICANON | ECHO | ISIG;
  settings.c_cc[VMIN] = 1;
  return settings;
}
termios settings = terminal();

/// File status flags; Emscripten cannot reset O_NONBLOCK.
int flags = O_RDWR;

/// The mode, as in ros_reading().
int keyboard()
{
  if (settings.c_lflag & ICANON) {return settings.c_lflag & ECHO ? 0 : 1;}
  return settings.c_lflag & ISIG ? 2 : 3;
}

enum class Came { something, nothing, signal };

/// Wait for input, up to a number of milliseconds; without a limit if negative.
Came wait_for_keys(double milliseconds)
{
  const bool patient = milliseconds < 0;
  const double end = rclcpp::detail::now() + milliseconds;
  // A program that polls yields to the page.
  double left = milliseconds;
  if (patient) {std::fflush(stdout);}
  ros_reading(keyboard());
  while (ros_typed() < 0) {
    const int signal = rclcpp::detail::suspend(left);
    if (signal) {
      std::raise(signal);
      return Came::signal;
    }
    if (!patient) {
      left = end - rclcpp::detail::now();
      if (left <= 0) {return ros_typed() < 0 ? Came::nothing : Came::something;}
    }
  }
  return Came::something;
}

double wait_of_read()
{
  if (flags & O_NONBLOCK) {return 0;}
  // Without a minimum number of characters, a terminal waits for VTIME tenths of a second.
  const bool patient = settings.c_lflag & ICANON || settings.c_cc[VMIN] > 0;
  return patient ? -1 : 100 * settings.c_cc[VTIME];
}

}  // namespace

extern "C" {

int tcgetattr(int, termios * now)
{
  *now = settings;
  return 0;
}

int tcsetattr(int, int, const termios * wanted)
{
  settings = *wanted;
  return 0;
}

__wasi_errno_t __real___wasi_fd_read(
  __wasi_fd_t file, const __wasi_iovec_t * parts, size_t count, __wasi_size_t * got);

/// All input passes through here: read(), the streams of C and those of C++.
__wasi_errno_t __wrap___wasi_fd_read(
  __wasi_fd_t file, const __wasi_iovec_t * parts, size_t count, __wasi_size_t * got)
{
  if (file != STDIN_FILENO) {return __real___wasi_fd_read(file, parts, count, got);}
  *got = 0;
  switch (wait_for_keys(wait_of_read())) {
    case Came::signal: return __WASI_ERRNO_INTR;
    case Came::nothing:
      return flags & O_NONBLOCK ? __WASI_ERRNO_AGAIN : __WASI_ERRNO_SUCCESS;
    case Came::something: break;
  }
  for (size_t part = 0; part < count && ros_typed() >= 0; ++part) {
    const auto size = static_cast<int32_t>(parts[part].buf_len);
    const int32_t taken = ros_take_typed(parts[part].buf, size);
    *got += taken;
    if (taken < size) {break;}
  }
  return __WASI_ERRNO_SUCCESS;
}

int __real_fcntl(int file, int command, ...);

int __wrap_fcntl(int file, int command, ...)
{
  va_list rest;
  va_start(rest, command);
  const long argument = va_arg(rest, long);
  va_end(rest);
  if (file == STDIN_FILENO && command == F_GETFL) {return flags;}
  if (file == STDIN_FILENO && command == F_SETFL) {
    flags = static_cast<int>(argument);
    return 0;
  }
  return __real_fcntl(file, command, argument);
}

int __real_poll(pollfd * files, nfds_t count, int timeout);

int __wrap_poll(pollfd * files, nfds_t count, int timeout)
{
  const auto keys = std::find_if(
    files, files + count, [](const pollfd & one) {return one.fd == STDIN_FILENO;});
  if (keys == files + count) {return __real_poll(files, count, timeout);}
  for (pollfd * one = files; one != files + count; ++one) {one->revents = 0;}
  const Came came = wait_for_keys(timeout);
  if (came == Came::something) {keys->revents = POLLIN;}
  return came == Came::signal ? -1 : came == Came::something;
}

int __real_select(int count, fd_set * read, fd_set * write, fd_set * except, timeval * timeout);

int __wrap_select(int count, fd_set * read, fd_set * write, fd_set * except, timeval * timeout)
{
  if (!read || !FD_ISSET(STDIN_FILENO, read)) {
    return __real_select(count, read, write, except, timeout);
  }
  for (fd_set * set : {read, write, except}) {
    if (set) {FD_ZERO(set);}
  }
  const Came came = wait_for_keys(timeout ? timeout->tv_sec * 1e3 + timeout->tv_usec / 1e3 : -1);
  if (came == Came::something) {FD_SET(STDIN_FILENO, read);}
  return came == Came::signal ? -1 : came == Came::something;
}

}
