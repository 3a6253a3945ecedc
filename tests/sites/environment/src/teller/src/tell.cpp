// Prints environment variables, a line each, and one log message.
#include <cstdio>
#include <cstdlib>

#include "rclcpp/rclcpp.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<rclcpp::Node>("tell");
  for (const char * name : {"TEAM", "LANE", "DATA"}) {
    const char * value = std::getenv(name);
    std::printf("%s %s\n", name, value ? value : "(unset)");
  }
  RCLCPP_WARN(node->get_logger(), "hello");
  rclcpp::shutdown();
}
