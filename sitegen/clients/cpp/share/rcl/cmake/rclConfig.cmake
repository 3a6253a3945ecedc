# Its public functions are in the rclcpp library.
include_guard(GLOBAL)
include(CMakeFindDependencyMacro)
find_dependency(rclcpp)
sitegen_part_of_rclcpp(rcl)
