# A part of the rclcpp library. In a package that finds it, ament_package() gives programs access to
# the files that packages install to share/.
include_guard(GLOBAL)
include(CMakeFindDependencyMacro)
find_dependency(rclcpp)
sitegen_part_of_rclcpp(ament_index_cpp)
