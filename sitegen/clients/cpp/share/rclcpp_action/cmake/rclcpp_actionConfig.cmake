# Actions are a part of the rclcpp library.
include_guard(GLOBAL)
include(CMakeFindDependencyMacro)
find_dependency(rclcpp)
find_dependency(action_msgs)
find_dependency(unique_identifier_msgs)

add_library(rclcpp_action::rclcpp_action INTERFACE IMPORTED GLOBAL)
target_link_libraries(rclcpp_action::rclcpp_action INTERFACE
  rclcpp::rclcpp ${action_msgs_TARGETS} ${unique_identifier_msgs_TARGETS})
set(rclcpp_action_TARGETS rclcpp_action::rclcpp_action)
set(rclcpp_action_LIBRARIES rclcpp_action::rclcpp_action)
