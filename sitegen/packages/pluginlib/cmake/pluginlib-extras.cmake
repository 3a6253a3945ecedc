# Plugins: classes in libraries, which an XML file describes.
set(_pluginlib_describe "${CMAKE_CURRENT_LIST_DIR}/describe.py")
set(_pluginlib_include "${CMAKE_CURRENT_LIST_DIR}/../include")
if(NOT TARGET sitegen_plugins)
  add_library(sitegen_plugins INTERFACE IMPORTED GLOBAL)
endif()

# All libraries of a package are known only in ament_package().
function(pluginlib_export_plugin_description_file category file)
  set_property(GLOBAL APPEND PROPERTY SITEGEN_PLUGINS "${category}@${file}")
  set_property(GLOBAL APPEND PROPERTY SITEGEN_BEFORE_PACKAGE _pluginlib_describe_all)
endfunction()

function(pluginlib_enable_plugin_testing)
endfunction()

# Add the plugin descriptions to their libraries, and link these into the programs of this package.
function(_pluginlib_describe_all)
  get_property(items GLOBAL PROPERTY SITEGEN_PLUGINS)
  set(number 0)
  foreach(item IN LISTS items)
    # Several files may describe the plugins of one library.
    math(EXPR number "${number} + 1")
    set(folder "${CMAKE_CURRENT_BINARY_DIR}/pluginlib/${number}")
    string(REPLACE "@" ";" item "${item}")
    list(GET item 0 category)
    list(GET item 1 file)
    get_filename_component(path "${file}" ABSOLUTE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${path}")
    execute_process(
      COMMAND "${SITEGEN_PYTHON}" "${_pluginlib_describe}" "${path}" "${PROJECT_NAME}" "${category}"
        "${folder}"
      OUTPUT_VARIABLE libraries ERROR_VARIABLE problems RESULT_VARIABLE failed)
    if(failed)
      message(FATAL_ERROR "\n${problems}")
    endif()
    _pluginlib_built(libraries "${file}")
    foreach(library IN LISTS libraries)
      _pluginlib_target("${library}" target)
      sitegen_keep_optional(${target} kept)
      if(NOT kept)
        continue()
      endif()
      target_sources(${target} PRIVATE "${folder}/${category}.${library}.cpp")
      target_include_directories(${target} PRIVATE "${_pluginlib_include}")
      set_property(TARGET sitegen_plugins APPEND PROPERTY INTERFACE_LINK_LIBRARIES ${target})
      sitegen_link_with("sitegen_plugins" ${target})
    endforeach()
  endforeach()
endfunction()

# Leave the libraries that this package builds. On a robot, only a program that loads one of the
# others fails; a description of nothing else is a mistake.
function(_pluginlib_built names file)
  set(built ${${names}})
  foreach(library IN LISTS ${names})
    _pluginlib_target("${library}" target)
    if("${target}" STREQUAL "")
      list(REMOVE_ITEM built "${library}")
    endif()
  endforeach()
  if(NOT built)
    message(FATAL_ERROR
      "${file} names the library '${${names}}', which this package does not build")
  endif()
  set(${names} "${built}" PARENT_SCOPE)
endfunction()

# The target that builds `library`, whose file name may begin with "lib", or "".
function(_pluginlib_target library result)
  sitegen_libraries_below("${PROJECT_SOURCE_DIR}" targets)
  set(${result} "" PARENT_SCOPE)
  foreach(target IN LISTS targets)
    get_target_property(name ${target} OUTPUT_NAME)
    if(target STREQUAL library OR name STREQUAL library)
      set(${result} ${target} PARENT_SCOPE)
      return()
    endif()
  endforeach()
endfunction()
