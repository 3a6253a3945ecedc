// Start and end of the program: init(), ok(), shutdown().
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp/context.hpp"
#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/init_options.hpp"

namespace rclcpp
{

enum class SignalHandlerOptions {All, SigInt, SigTerm, None};

/// Parse the ROS arguments of the command line. SIGINT, from the Stop button, is the only signal.
void init(
  int argc, char const * const * argv, const InitOptions & options = InitOptions(),
  SignalHandlerOptions signals = SignalHandlerOptions::All);
std::vector<std::string> init_and_remove_ros_arguments(
  int argc, char const * const * argv, const InitOptions & options = InitOptions());
std::vector<std::string> remove_ros_arguments(int argc, char const * const * argv);

bool install_signal_handlers(SignalHandlerOptions signals = SignalHandlerOptions::All);
bool signal_handlers_installed();
bool uninstall_signal_handlers();

/// These use the global context by default.
bool ok(Context::SharedPtr context = nullptr);
bool shutdown(
  Context::SharedPtr context = nullptr,
  const std::string & reason = "user called rclcpp::shutdown()");
void on_shutdown(std::function<void()> callback, Context::SharedPtr context = nullptr);

/// Sleep; false on shutdown.
bool sleep_for(
  const std::chrono::nanoseconds & duration, Context::SharedPtr context = nullptr);

template<class T>
const char * get_c_string(const T & text)
{
  if constexpr (std::is_convertible_v<const T &, const char *>) {
    return text;
  } else {
    return text.c_str();
  }
}

}  // namespace rclcpp
