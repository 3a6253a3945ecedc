# A part of the rclcpp library. In a package that finds it, ament_package() embeds in programs the files
# that the builds of packages make and install to share/.
include_guard(GLOBAL)
include(CMakeFindDependencyMacro)
find_dependency(rclcpp)
sitegen_part_of_rclcpp(ament_index_cpp)
