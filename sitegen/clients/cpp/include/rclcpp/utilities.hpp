// The life of the program: init, ok, shutdown.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace rclcpp
{

enum class SignalHandlerOptions {All, SigInt, SigTerm, None};

class InitOptions
{
public:
  InitOptions() = default;
};

/// Read the ROS arguments of the command line. The reader's Stop button is the only signal here.
void init(
  int argc, char const * const * argv, const InitOptions & options = InitOptions(),
  SignalHandlerOptions signals = SignalHandlerOptions::All);
std::vector<std::string> init_and_remove_ros_arguments(
  int argc, char const * const * argv, const InitOptions & options = InitOptions());
std::vector<std::string> remove_ros_arguments(int argc, char const * const * argv);

bool ok();
bool shutdown(const std::string & reason = "user called rclcpp::shutdown()");
void on_shutdown(std::function<void()> callback);

/// Sleep; false when the program was shut down meanwhile.
bool sleep_for(const std::chrono::nanoseconds & duration);

}  // namespace rclcpp
