# A part of the rclcpp library. ament_package() gives programs of who finds it the files that their
# packages install to share/.
include_guard(GLOBAL)
include(CMakeFindDependencyMacro)
find_dependency(rclcpp)
add_library(ament_index_cpp::ament_index_cpp INTERFACE IMPORTED GLOBAL)
target_link_libraries(ament_index_cpp::ament_index_cpp INTERFACE rclcpp::rclcpp)
set(ament_index_cpp_TARGETS ament_index_cpp::ament_index_cpp)
set(ament_index_cpp_LIBRARIES ament_index_cpp::ament_index_cpp)
