# What is changed in the targets of a package after its CMakeLists.txt has described them.
include_guard(GLOBAL)

# All libraries are static here. In a shared library, main() gives way to that of the program.
function(_sitegen_weaken_main target)
  get_target_property(folder ${target} SOURCE_DIR)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(path "${source}" ABSOLUTE BASE_DIR "${folder}")
    if(source MATCHES "\\.(c|cc|cpp|cxx)$" AND EXISTS "${path}")
      file(STRINGS "${path}" found LIMIT_COUNT 1 REGEX "^[ \t]*int[ \t]+main[ \t]*\\(")
      if(found)
        set_property(SOURCE "${source}" TARGET_DIRECTORY ${target} APPEND PROPERTY
          COMPILE_OPTIONS -include "${SITEGEN_CPP}/src/platform/weak_main.h")
      endif()
    endif()
  endforeach()
endfunction()

function(sitegen_finish folder)
  get_property(targets DIRECTORY "${folder}" PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(NOT type STREQUAL "INTERFACE_LIBRARY")
      # The programs of Qt that these would run are not there.
      set_target_properties(${target} PROPERTIES AUTOMOC OFF AUTOUIC OFF AUTORCC OFF)
    endif()
    if(type STREQUAL "EXECUTABLE")
      # sitegen finds programs by their names, whatever folder the package chooses for them.
      set_target_properties(${target} PROPERTIES
        RUNTIME_OUTPUT_DIRECTORY "${SITEGEN_PROGRAMS}" PREFIX "" SUFFIX ".js")
    elseif(type MATCHES "^(STATIC|SHARED|MODULE)_LIBRARY$")
      _sitegen_weaken_main(${target})
    endif()
  endforeach()
  get_property(folders DIRECTORY "${folder}" PROPERTY SUBDIRECTORIES)
  foreach(subfolder IN LISTS folders)
    sitegen_finish("${subfolder}")
  endforeach()
endfunction()
