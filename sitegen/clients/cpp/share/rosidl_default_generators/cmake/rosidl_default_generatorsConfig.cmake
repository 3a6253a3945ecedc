# rosidl_generate_interfaces: a package's own messages, by the real generator (sitegen.interfaces.generator).
include_guard(GLOBAL)
find_package(ament_cmake REQUIRED)

function(rosidl_generate_interfaces target)
  cmake_parse_arguments(ARG
    "ADD_LINTER_TESTS;SKIP_GROUP_MEMBERSHIP_CHECK;SKIP_INSTALL" "LIBRARY_NAME" "DEPENDENCIES" ${ARGN})
  set(files "")
  foreach(file IN LISTS ARG_UNPARSED_ARGUMENTS)
    string(REGEX REPLACE "^.*:" "" file "${file}")  # base:relative, as rosidl_cmake allows
    list(APPEND files "${file}")
    set_property(DIRECTORY APPEND PROPERTY
      CMAKE_CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${file}")
  endforeach()
  execute_process(
    COMMAND "${SITEGEN_PYTHON}" -m sitegen.interfaces.generator "${SITEGEN_PREFIX}" "${CMAKE_PREFIX_PATH}"
      "${PROJECT_NAME}" "${CMAKE_CURRENT_SOURCE_DIR}" ${files}
    OUTPUT_QUIET
    RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "the interfaces of '${PROJECT_NAME}' could not be generated")
  endif()
  find_package(${PROJECT_NAME} REQUIRED PATHS "${SITEGEN_PREFIX}/share/${PROJECT_NAME}/cmake"
    NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH)
  set_property(GLOBAL PROPERTY SITEGEN_INTERFACES ON)
  add_custom_target(${target})
  foreach(part generator_c generator_cpp typesupport_c typesupport_cpp)
    add_library(${target}__rosidl_${part} ALIAS ${PROJECT_NAME}::${PROJECT_NAME})
  endforeach()
  set(rosidl_generate_interfaces_TARGETS ${PROJECT_NAME}::${PROJECT_NAME} PARENT_SCOPE)
endfunction()

function(rosidl_get_typesupport_target variable target typesupport)
  set(${variable} "${PROJECT_NAME}::${PROJECT_NAME}" PARENT_SCOPE)
endfunction()

macro(rosidl_target_interfaces target interfaces typesupport)
  target_link_libraries(${target} ${PROJECT_NAME}::${PROJECT_NAME})
endmacro()
