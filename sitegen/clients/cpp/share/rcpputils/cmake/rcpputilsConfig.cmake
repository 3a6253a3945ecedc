# Headers that come with rclcpp.
include_guard(GLOBAL)
include(CMakeFindDependencyMacro)
find_dependency(rclcpp)
sitegen_part_of_rclcpp(rcpputils)
