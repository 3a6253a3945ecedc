#include "rclcpp/utilities.hpp"

#include <csignal>
#include <utility>

#include "rclcpp/detail/platform.hpp"
#include "rclcpp/logging.hpp"

namespace rclcpp
{

namespace
{

bool handles_signals = false;

Context & context_or_default(const Context::SharedPtr & context)
{
  return context ? *context : *contexts::get_global_default_context();
}

void on_signal(int signal)
{
  RCLCPP_INFO(Logger("rclcpp"), "signal_handler(signum=%d)", signal);
  auto & context = *contexts::get_global_default_context();
  if (context.get_init_options().shutdown_on_signal) {context.shutdown("signal handler");}
}

}  // namespace

void init(
  int argc, char const * const * argv, const InitOptions & options, SignalHandlerOptions signals)
{
  contexts::get_global_default_context()->init(argc, argv, options);
  install_signal_handlers(signals);
}

std::vector<std::string> init_and_remove_ros_arguments(
  int argc, char const * const * argv, const InitOptions & options)
{
  init(argc, argv, options);
  return contexts::get_global_default_context()->arguments().others;
}

std::vector<std::string> remove_ros_arguments(int argc, char const * const * argv)
{
  return detail::parse_arguments(argc, argv).others;
}

bool install_signal_handlers(SignalHandlerOptions signals)
{
  if (signals != SignalHandlerOptions::All && signals != SignalHandlerOptions::SigInt) {
    return false;
  }
  if (std::exchange(handles_signals, true)) {return false;}
  std::signal(SIGINT, on_signal);
  return true;
}

bool signal_handlers_installed() {return handles_signals;}

bool uninstall_signal_handlers()
{
  if (!std::exchange(handles_signals, false)) {return false;}
  std::signal(SIGINT, SIG_DFL);
  return true;
}

bool ok(Context::SharedPtr context)
{
  const auto & asked = context_or_default(context);
  // A loop that only polls ok() must notice Stop.
  if (asked.is_valid()) {detail::breathe();}
  return asked.is_valid();
}

bool shutdown(Context::SharedPtr context, const std::string & reason)
{
  const bool is_default = !context || context == contexts::get_global_default_context();
  const bool was_valid = context_or_default(context).shutdown(reason);
  if (is_default) {uninstall_signal_handlers();}
  return was_valid;
}

void on_shutdown(std::function<void()> callback, Context::SharedPtr context)
{
  context_or_default(context).on_shutdown(std::move(callback));
}

bool sleep_for(const std::chrono::nanoseconds & duration, Context::SharedPtr context)
{
  return context_or_default(context).sleep_for(duration);
}

}  // namespace rclcpp
