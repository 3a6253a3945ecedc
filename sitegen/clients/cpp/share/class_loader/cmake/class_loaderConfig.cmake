# Headers that come with rclcpp.
include_guard(GLOBAL)
include(CMakeFindDependencyMacro)
find_dependency(rclcpp)
add_library(class_loader::class_loader INTERFACE IMPORTED GLOBAL)
target_link_libraries(class_loader::class_loader INTERFACE rclcpp::rclcpp)
set(class_loader_TARGETS class_loader::class_loader)
set(class_loader_LIBRARIES class_loader::class_loader)
