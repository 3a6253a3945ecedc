# Its types are a part of the rclcpp library; pages have no middleware.
include_guard(GLOBAL)
include(CMakeFindDependencyMacro)
find_dependency(rclcpp)
sitegen_part_of_rclcpp(rmw)
