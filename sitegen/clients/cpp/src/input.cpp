// What POSIX has for the keyboard. In a page nobody types for a compiled program, so to read waits as it
// does at a terminal that is left alone, and other threads go on meanwhile.
#include <sys/uio.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

#include "rclcpp/detail/platform.hpp"
#include "rclcpp/detail/stacks.hpp"

namespace
{

termios terminal()
{
  termios settings{};
  settings.c_lflag = ICANON | ECHO | ISIG;
  settings.c_cc[VMIN] = 1;
  return settings;
}
termios settings = terminal();

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

ssize_t read(int file, void * to, size_t size)
{
  if (file != STDIN_FILENO) {
    const iovec part{to, size};
    return readv(file, &part, 1);
  }
  // Where a terminal need not wait for a character, it waits for some tenths of a second.
  const bool patient = settings.c_lflag & ICANON || settings.c_cc[VMIN] > 0;
  const double end = rclcpp::detail::now() + 100 * settings.c_cc[VTIME];
  double left = patient ? -1 : 100 * settings.c_cc[VTIME];
  do {
    const int signal = rclcpp::detail::suspend(left);
    if (signal) {
      std::raise(signal);
      errno = EINTR;
      return -1;
    }
    left = patient ? -1 : end - rclcpp::detail::now();
  } while (patient || left > 0);
  return 0;
}

}
