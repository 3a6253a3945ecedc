include_guard(GLOBAL)
include(CMakeFindDependencyMacro)
find_dependency(builtin_interfaces)
find_dependency(rcl_interfaces)
find_dependency(rosgraph_msgs)

add_library(rclcpp::rclcpp STATIC IMPORTED GLOBAL)
set_target_properties(rclcpp::rclcpp PROPERTIES
  IMPORTED_LOCATION "${SITEGEN_RCLCPP}"
  INTERFACE_INCLUDE_DIRECTORIES "${SITEGEN_CPP}/include"
  INTERFACE_COMPILE_FEATURES cxx_std_17
  INTERFACE_LINK_LIBRARIES "${builtin_interfaces_TARGETS};${rcl_interfaces_TARGETS};${rosgraph_msgs_TARGETS}")
set(rclcpp_TARGETS rclcpp::rclcpp)
set(rclcpp_LIBRARIES rclcpp::rclcpp)
