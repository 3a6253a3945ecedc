# sitegen::engine: how programs are compiled and linked for SITEGEN_ENGINE, "jspi" or "asyncify".
include_guard(GLOBAL)

get_filename_component(SITEGEN_CPP "${CMAKE_CURRENT_LIST_DIR}/.." ABSOLUTE)

add_library(sitegen::engine INTERFACE IMPORTED GLOBAL)
set(_settings
  MODULARIZE=1 EXPORT_ES6=1 USE_ES6_IMPORT_META=1 ENVIRONMENT=worker
  ALLOW_MEMORY_GROWTH=1 TOTAL_STACK=1048576 EXIT_RUNTIME=1
  # The page enters ros_main(), which calls main().
  INVOKE_RUN=0 EXPORTED_FUNCTIONS=_main,_ros_main,_ros_main_pointer)
if(SITEGEN_ENGINE STREQUAL "jspi")
  # Exceptions of WebAssembly: those of JavaScript would stand between main() and the wait.
  set(_exceptions -fwasm-exceptions)
else()
  set(_exceptions -fexceptions)
  list(APPEND _settings ASYNCIFY=1 ASYNCIFY_IMPORTS=ros_wait ASYNCIFY_STACK_SIZE=65536)
endif()
target_compile_options(sitegen::engine INTERFACE ${_exceptions})
target_link_options(sitegen::engine INTERFACE
  ${_exceptions}
  "SHELL:--js-library ${SITEGEN_CPP}/src/host.js" "SHELL:--pre-js ${SITEGEN_CPP}/src/host_pre.js")
foreach(_setting IN LISTS _settings)
  target_link_options(sitegen::engine INTERFACE "SHELL:-s ${_setting}")
endforeach()
