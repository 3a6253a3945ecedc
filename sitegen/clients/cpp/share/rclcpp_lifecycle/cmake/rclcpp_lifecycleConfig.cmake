# Lifecycle nodes are a part of the rclcpp library.
include_guard(GLOBAL)
include(CMakeFindDependencyMacro)
find_dependency(rclcpp)
find_dependency(lifecycle_msgs)

add_library(rclcpp_lifecycle::rclcpp_lifecycle INTERFACE IMPORTED GLOBAL)
target_link_libraries(rclcpp_lifecycle::rclcpp_lifecycle INTERFACE
  rclcpp::rclcpp ${lifecycle_msgs_TARGETS})
set(rclcpp_lifecycle_TARGETS rclcpp_lifecycle::rclcpp_lifecycle)
set(rclcpp_lifecycle_LIBRARIES rclcpp_lifecycle::rclcpp_lifecycle)
