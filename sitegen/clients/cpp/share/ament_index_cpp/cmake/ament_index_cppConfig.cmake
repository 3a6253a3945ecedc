# A part of the rclcpp library. ament_package() gives programs of who finds it the files that their
# packages install to share/.
include_guard(GLOBAL)
include(CMakeFindDependencyMacro)
find_dependency(rclcpp)
sitegen_part_of_rclcpp(ament_index_cpp)
