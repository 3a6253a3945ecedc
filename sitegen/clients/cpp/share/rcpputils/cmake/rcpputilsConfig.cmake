# A part of the rclcpp library.
include_guard(GLOBAL)
include(CMakeFindDependencyMacro)
find_dependency(rclcpp)
add_library(rcpputils::rcpputils INTERFACE IMPORTED GLOBAL)
target_link_libraries(rcpputils::rcpputils INTERFACE rclcpp::rclcpp)
set(rcpputils_TARGETS rcpputils::rcpputils)
set(rcpputils_LIBRARIES rcpputils::rcpputils)
