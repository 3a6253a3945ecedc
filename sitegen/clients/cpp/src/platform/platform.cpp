#include "rclcpp/detail/platform.hpp"

#include <emscripten.h>
#include <sched.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <functional>
#include <new>
#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

#include "rclcpp/detail/host.h"
#include "rclcpp/detail/stacks.hpp"

extern "C" int ros_user_main(int argc, char ** argv);

namespace rclcpp
{
namespace detail
{

double now() {return ros_now();}

std::int64_t nanoseconds(double milliseconds)
{
  const auto whole = static_cast<std::int64_t>(milliseconds);
  return whole * 1000000 + std::llround((milliseconds - static_cast<double>(whole)) * 1e6);
}

namespace
{
// A busy program lets the event loop turn this often (ms): often enough for a Stop button, seldom
// enough to cost nothing.
constexpr double kBreath = 4;
double last_wait = 0;
bool ending = false;
}  // namespace

void wait(double milliseconds)
{
  const int signal = suspend(milliseconds);
  last_wait = now();
  if (signal) {std::raise(signal);}
}

void breathe()
{
  // What runs at exit() cannot wait any more.
  if (!ending && now() - last_wait >= kBreath) {wait(0);}
}

void sleep(double milliseconds, const std::function<bool()> & stop)
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

[[noreturn]] void end(int code)
{
  ending = true;
  std::exit(code);
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

void guarded(const std::function<void()> & body)
{
  try {
    body();
  } catch (...) {
    ros_fail(describe_exception().c_str());
    end(1);
  }
}

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
  int code = 0;
  rclcpp::detail::guarded(
    [&] {code = ros_user_main(static_cast<int>(words.size()), argv.data());});
  rclcpp::detail::end(code);
}

EMSCRIPTEN_KEEPALIVE void * ros_main_pointer(void)
{
  return reinterpret_cast<void *>(&ros_main);
}

// Emscripten ends a program by an exception of JavaScript, which functions that are noexcept stop, and so
// never end. A trap passes through all of them. The linker puts these in the place of Emscripten's.
[[noreturn]] void __wrap_abort(void)
{
  ros_fail("aborted");
  __builtin_trap();
}

[[noreturn]] void __wrap___assert_fail(
  const char * condition, const char * file, int line, const char *)
{
  const auto place = std::string(file) + ":" + std::to_string(line);
  ros_fail((place + ": assertion failed: " + condition).c_str());
  __builtin_trap();
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

// std::this_thread::yield
int sched_yield(void)
{
  rclcpp::detail::wait(0);
  return 0;
}

}  // extern "C"
