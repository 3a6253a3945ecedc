include_guard(GLOBAL)
include(CMakeFindDependencyMacro)
find_dependency(builtin_interfaces)
find_dependency(rcl_interfaces)
find_dependency(rosgraph_msgs)
find_dependency(service_msgs)
find_dependency(statistics_msgs)
find_dependency(type_description_interfaces)

add_library(rclcpp::rclcpp STATIC IMPORTED GLOBAL)
set_target_properties(rclcpp::rclcpp PROPERTIES
  IMPORTED_LOCATION "${SITEGEN_RCLCPP}"
  INTERFACE_INCLUDE_DIRECTORIES "${SITEGEN_CPP}/include"
  INTERFACE_COMPILE_FEATURES cxx_std_17
  INTERFACE_LINK_LIBRARIES "${builtin_interfaces_TARGETS};${rcl_interfaces_TARGETS};${rosgraph_msgs_TARGETS};${service_msgs_TARGETS};${statistics_msgs_TARGETS};${type_description_interfaces_TARGETS}")
set(rclcpp_TARGETS rclcpp::rclcpp)
set(rclcpp_LIBRARIES rclcpp::rclcpp)

# Define a package that is a part of the rclcpp library.
function(sitegen_part_of_rclcpp package)
  if(NOT TARGET ${package}::${package})
    add_library(${package}::${package} INTERFACE IMPORTED GLOBAL)
    target_link_libraries(${package}::${package} INTERFACE rclcpp::rclcpp)
  endif()
  set(${package}_TARGETS ${package}::${package} PARENT_SCOPE)
  set(${package}_LIBRARIES ${package}::${package} PARENT_SCOPE)
endfunction()

# Packages that are found together with rclcpp.
foreach(package rcl rcpputils rcutils rmw)
  find_dependency(${package})
endforeach()
