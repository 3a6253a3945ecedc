#include "rclcpp/detail/platform.hpp"

#include <emscripten.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

#include "rclcpp/detail/host.h"

extern "C" int ros_user_main(int argc, char ** argv);

namespace rclcpp
{
namespace detail
{

double now() {return ros_now();}

void wait(double milliseconds)
{
  if (const int signal = ros_wait(milliseconds)) {std::raise(signal);}
}

void sleep(double milliseconds, bool (* stop)())
{
  const double end = now() + milliseconds;
  // Once at least, so that a loop around a sleep of nothing lets the page breathe.
  do {
    // The clock is read once: a negative rest would wait without end.
    wait(std::max(0.0, end - now()));
  } while (now() < end && !(stop && stop()));
}

namespace
{
/// `mangled`, a class name as typeid gives it, as C++ writes it. abi::__cxa_demangle knows every
/// name there is, and would be a third of a small program.
std::string class_name(const char * mangled)
{
  std::string name;
  if (*mangled == 'N') {++mangled;}
  if (mangled[0] == 'S' && mangled[1] == 't') {
    name = "std";
    mangled += 2;
  }
  while (*mangled >= '0' && *mangled <= '9') {
    char * part;
    const auto size = std::strtoul(mangled, &part, 10);
    name += name.empty() ? "" : "::";
    name.append(part, size);
    mangled = part + size;
  }
  return name;
}

/// The type and text of the exception that is being handled.
std::string describe_exception()
{
  try {
    throw;
  } catch (const std::bad_alloc &) {
    return "out of memory (std::bad_alloc)";
  } catch (const std::exception & error) {
    return class_name(typeid(error).name()) + ": " + error.what();
  } catch (const std::string & text) {
    return text;
  } catch (const char * text) {
    return text;
  } catch (...) {
    return "an exception that is no std::exception";
  }
}

std::vector<std::string> command_line()
{
  std::vector<std::string> words;
  for (std::int32_t index = 0;; ++index) {
    const std::int32_t size = ros_argument(index, nullptr, 0);
    if (size < 0) {return words;}
    std::string word(static_cast<std::size_t>(size), '\0');
    ros_argument(index, word.data(), size);
    words.push_back(std::move(word));
  }
}
}  // namespace

}  // namespace detail
}  // namespace rclcpp

extern "C" {

/// Run the program; the page enters it here. It ends by exit(), never by returning.
EMSCRIPTEN_KEEPALIVE void ros_main(void)
{
  auto words = rclcpp::detail::command_line();
  std::vector<char *> argv;
  for (auto & word : words) {argv.push_back(word.data());}
  argv.push_back(nullptr);
  int code = 1;
  try {
    code = ros_user_main(static_cast<int>(words.size()), argv.data());
  } catch (...) {
    ros_fail(rclcpp::detail::describe_exception().c_str());
  }
  std::exit(code);
}

EMSCRIPTEN_KEEPALIVE void * ros_main_pointer(void)
{
  return reinterpret_cast<void *>(&ros_main);
}

// libc's own sleeps would spin: std::this_thread::sleep_for and its elders come here instead.
int nanosleep(const struct timespec * time, struct timespec *)
{
  rclcpp::detail::sleep(
    static_cast<double>(time->tv_sec) * 1e3 + static_cast<double>(time->tv_nsec) / 1e6, nullptr);
  return 0;
}

int usleep(unsigned microseconds)
{
  rclcpp::detail::sleep(microseconds / 1e3, nullptr);
  return 0;
}

unsigned sleep(unsigned seconds)
{
  rclcpp::detail::sleep(seconds * 1e3, nullptr);
  return 0;
}

}  // extern "C"
