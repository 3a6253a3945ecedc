# Its additions to ament_cmake are for shared libraries and tests.
include_guard(GLOBAL)
find_package(ament_cmake REQUIRED)
find_package(ament_cmake_ros_core REQUIRED)
