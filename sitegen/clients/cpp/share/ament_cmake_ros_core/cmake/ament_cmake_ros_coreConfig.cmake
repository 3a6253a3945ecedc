# The compiler options that it sets do not apply to pages.
include_guard(GLOBAL)
find_package(ament_cmake REQUIRED)
add_library(ament_cmake_ros_core::ament_ros_defaults INTERFACE IMPORTED GLOBAL)
