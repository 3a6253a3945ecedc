// Says what it hears, and when that is by its clock.
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("hears");
  node->declare_parameter("loud", false);  // without a parameter, use_sim_time has no effect
  auto hear = [&](const char * what) {
      return [&, what](const std_msgs::msg::String & message) {
               RCLCPP_INFO(
                 node->get_logger(), "%s '%s' at %.3f", what, message.data.c_str(),
                 node->now().seconds());
             };
    };
  auto words = node->create_subscription<std_msgs::msg::String>("words", 100, hear("word"));
  auto said = node->create_subscription<std_msgs::msg::String>("said", 100, hear("said"));
  auto latched = node->create_subscription<std_msgs::msg::String>(
    "latched", rclcpp::QoS(1).transient_local(), hear("latched"));
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
