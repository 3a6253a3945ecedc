# What it sets for compilers says nothing about those of a page.
include_guard(GLOBAL)
find_package(ament_cmake REQUIRED)
add_library(ament_cmake_ros_core::ament_ros_defaults INTERFACE IMPORTED GLOBAL)
