# ament_cmake for programs of a page: what a package's CMakeLists.txt calls, with the meaning that
# it has when only its executables are wanted. Tests and linters are left out.
include_guard(GLOBAL)
include(GNUInstallDirs)

set(BUILD_TESTING OFF)

function(ament_target_dependencies target)
  set(visibility "")
  foreach(package IN LISTS ARGN)
    if(package MATCHES "^(PUBLIC|PRIVATE|INTERFACE)$")
      set(visibility ${package})
      continue()
    elseif(package STREQUAL "SYSTEM")
      continue()
    endif()
    if(NOT ${package}_FOUND)
      message(FATAL_ERROR
        "ament_target_dependencies() the passed package name '${package}' was not found before")
    endif()
    if(${package}_TARGETS)
      target_link_libraries(${target} ${visibility} ${${package}_TARGETS})
    else()
      target_include_directories(${target} PUBLIC ${${package}_INCLUDE_DIRS})
      target_link_libraries(${target} ${visibility} ${${package}_LIBRARIES})
    endif()
  endforeach()
endfunction()

# What matters to colcon, to other packages' installs or to tests, and not to a page.
foreach(command
  ament_add_gmock ament_add_gtest ament_add_pytest_test ament_add_test
  ament_environment_hooks ament_export_definitions ament_export_dependencies
  ament_export_include_directories ament_export_interfaces ament_export_libraries
  ament_export_link_flags ament_export_targets ament_index_register_resource
  ament_lint_auto_find_test_dependencies)
  cmake_language(EVAL CODE "macro(${command})\nendmacro()")
endforeach()

function(ament_package)
endfunction()
