#include "rclcpp_action/client.hpp"

#include "rclcpp/detail/platform.hpp"
#include "rclcpp/utilities.hpp"

namespace rclcpp_action
{

bool ClientBase::wait(double milliseconds) const
{
  const double end = rclcpp::detail::now() + milliseconds;
  while (!action_server_is_ready()) {
    // ok() may yield to the event loop, and events that arrive there would not end the following wait.
    const bool valid = rclcpp::contexts::get_global_default_context()->is_valid();
    const double left = end - rclcpp::detail::now();
    if (!valid || (milliseconds >= 0 && left <= 0)) {return false;}
    rclcpp::detail::wait(milliseconds < 0 ? -1 : left);
  }
  return true;
}

}  // namespace rclcpp_action
