# What package.xml says, as variables.
include_guard(GLOBAL)

# Set <package>_VERSION, <package>_BUILD_DEPENDS and the like, unless they are set.
macro(ament_package_xml)
  if(NOT DEFINED _AMENT_PACKAGE_NAME)
    cmake_parse_arguments(_ament_xml "" "DIRECTORY" "" ${ARGN})
    if(NOT _ament_xml_DIRECTORY)
      set(_ament_xml_DIRECTORY "${PROJECT_SOURCE_DIR}")
    endif()
    set_property(DIRECTORY APPEND PROPERTY
      CMAKE_CONFIGURE_DEPENDS "${_ament_xml_DIRECTORY}/package.xml")
    execute_process(
      COMMAND "${SITEGEN_PYTHON}" -m sitegen.workspace.manifestcmake
        "${_ament_xml_DIRECTORY}/package.xml"
      OUTPUT_FILE "${CMAKE_CURRENT_BINARY_DIR}/package_xml.cmake"
      RESULT_VARIABLE _ament_xml_failed)
    if(_ament_xml_failed)
      message(FATAL_ERROR "package.xml of '${PROJECT_NAME}' could not be read")
    endif()
    include("${CMAKE_CURRENT_BINARY_DIR}/package_xml.cmake")
    if(NOT _AMENT_PACKAGE_NAME STREQUAL PROJECT_NAME)
      message(FATAL_ERROR "package.xml names the package '${_AMENT_PACKAGE_NAME}', "
        "and CMakeLists.txt '${PROJECT_NAME}'")
    endif()
  endif()
endmacro()
