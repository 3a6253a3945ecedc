# Files of packages that run at certain points, such as ament_package().
include_guard(GLOBAL)

macro(ament_register_extension point package file)
  list(APPEND AMENT_EXTENSIONS_${point} "${package}:${file}")
endmacro()

macro(ament_execute_extensions point)
  cmake_parse_arguments(_ament_extensions "" "" "EXCLUDE" ${ARGN})
  foreach(_ament_extension IN LISTS AMENT_EXTENSIONS_${point})
    string(REGEX REPLACE ":.*" "" _ament_extension_package "${_ament_extension}")
    string(REGEX REPLACE "^[^:]*:" "" _ament_extension_file "${_ament_extension}")
    if(NOT _ament_extension_package IN_LIST _ament_extensions_EXCLUDE)
      include("${${_ament_extension_package}_DIR}/${_ament_extension_file}")
    endif()
  endforeach()
endmacro()
