# Its types are a part of the rclcpp library; there is no middleware to call.
include_guard(GLOBAL)
include(CMakeFindDependencyMacro)
find_dependency(rclcpp)
add_library(rmw::rmw INTERFACE IMPORTED GLOBAL)
target_link_libraries(rmw::rmw INTERFACE rclcpp::rclcpp)
set(rmw_TARGETS rmw::rmw)
set(rmw_LIBRARIES rmw::rmw)
