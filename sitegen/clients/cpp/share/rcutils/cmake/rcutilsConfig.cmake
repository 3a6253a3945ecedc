# A part of the rclcpp library.
include_guard(GLOBAL)
include(CMakeFindDependencyMacro)
find_dependency(rclcpp)
add_library(rcutils::rcutils INTERFACE IMPORTED GLOBAL)
target_link_libraries(rcutils::rcutils INTERFACE rclcpp::rclcpp)
set(rcutils_TARGETS rcutils::rcutils)
set(rcutils_LIBRARIES rcutils::rcutils)
