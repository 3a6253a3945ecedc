#include "rclcpp/utilities.hpp"

#include <csignal>
#include <utility>

#include "rclcpp/detail/arguments.hpp"
#include "rclcpp/detail/host.h"
#include "rclcpp/detail/platform.hpp"
#include "rclcpp/logging.hpp"

namespace rclcpp
{

namespace
{

struct Context
{
  bool valid = false;
  detail::Arguments arguments;
  std::vector<std::function<void()>> on_shutdown;
};

// Never destroyed: nodes with static lifetime still ask it while the program exits.
Context & context()
{
  static Context * context = new Context;
  return *context;
}

void on_signal(int signal)
{
  RCLCPP_INFO(get_logger("rclcpp"), "signal_handler(signum=%d)", signal);
  shutdown("signal handler");
}

}  // namespace

namespace detail
{
const Arguments & arguments() {return context().arguments;}
}  // namespace detail

void init(
  int argc, char const * const * argv, const InitOptions &, SignalHandlerOptions signals)
{
  context().arguments = detail::parse_arguments(argc, argv);
  context().valid = true;
  if (signals == SignalHandlerOptions::All || signals == SignalHandlerOptions::SigInt) {
    std::signal(SIGINT, on_signal);
  }
}

std::vector<std::string> init_and_remove_ros_arguments(
  int argc, char const * const * argv, const InitOptions & options)
{
  init(argc, argv, options);
  return context().arguments.others;
}

std::vector<std::string> remove_ros_arguments(int argc, char const * const * argv)
{
  return detail::parse_arguments(argc, argv).others;
}

bool ok() {return context().valid;}

bool shutdown(const std::string &)
{
  if (!context().valid) {return false;}
  context().valid = false;
  for (const auto & callback : context().on_shutdown) {callback();}
  ros_wake();
  return true;
}

void on_shutdown(std::function<void()> callback)
{
  context().on_shutdown.push_back(std::move(callback));
}

bool sleep_for(const std::chrono::nanoseconds & duration)
{
  detail::sleep(static_cast<double>(duration.count()) / 1e6, [] {return !ok();});
  return ok();
}

}  // namespace rclcpp
