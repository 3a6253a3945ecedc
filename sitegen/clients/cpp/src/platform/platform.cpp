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
// How often a busy program yields to the event loop (ms): often enough for the Stop button, rarely
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

bool is_ending() {return ending;}

void breathe()
{
  if (!ending && now() - last_wait >= kBreath) {wait(0);}
}

void sleep(double milliseconds, const std::function<bool()> & stop)
{
  const double end = now() + milliseconds;
  double left = milliseconds;
  // At least once, so that a loop with sleeps of zero length yields to the page.
  do {
    // The clock is read once: a negative remainder would wait forever.
    wait(std::max(0.0, left));
    // A double counts milliseconds since 1970 in steps of 0.24 µs: one step short would show as a
    // millisecond less in a program that measures with std::chrono.
    left = end + 1e-3 - now();
  } while (left > 0 && !(stop && stop()));
}

namespace
{
/// Demangle a class name of typeid. abi::__cxa_demangle handles all names, and would be a third of a
/// small program.
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

/// The type and text of the exception being handled.
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
    return "an exception not derived from std::exception";
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

/// Run the program; called by the page. It ends with exit() and never returns.
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

// Emscripten ends a program with a JavaScript exception, which cannot pass through noexcept functions,
// so the program would not end. A trap can. The linker replaces Emscripten's functions with these.
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

// The sleep functions of this libc would spin: sleep_for(), usleep() and others call these instead.
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
