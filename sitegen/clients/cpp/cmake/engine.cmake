# How programs are compiled and linked for SITEGEN_ENGINE, "jspi" or "asyncify". CMake includes this
# after project(), so that it is true of all targets: also of those that never heard of ROS.
include_guard(GLOBAL)

get_filename_component(SITEGEN_CPP "${CMAKE_CURRENT_LIST_DIR}/.." ABSOLUTE)

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
# What g++ takes where a package does not say; a standard that it sets comes later and wins.
add_compile_options(${_exceptions} $<$<COMPILE_LANGUAGE:CXX>:-std=gnu++17>)
add_link_options(
  ${_exceptions}
  "SHELL:--js-library ${SITEGEN_CPP}/src/platform/host.js" "SHELL:--pre-js ${SITEGEN_CPP}/src/platform/host_pre.js")
foreach(_setting IN LISTS _settings)
  add_link_options("SHELL:-s ${_setting}")
endforeach()
# Threads are ours (src/platform/threads.cpp): what is said here is never asked of the C library.
set(_threads
  create join detach self mutexattr_init mutexattr_settype mutex_init mutex_lock mutex_timedlock mutex_trylock mutex_unlock
  cond_init cond_wait cond_timedwait cond_signal cond_broadcast
  key_create key_delete getspecific setspecific)
list(TRANSFORM _threads PREPEND pthread_ OUTPUT_VARIABLE _wrapped)
# So is the keyboard (src/platform/input.cpp).
list(APPEND _wrapped abort __assert_fail __wasi_fd_read fcntl poll select)
if(SITEGEN_ENGINE STREQUAL "jspi")
  list(APPEND _wrapped __cxa_get_globals __cxa_get_globals_fast)
endif()
if(SITEGEN_DEBUG)
  # Names and lines, and what programs are checked for: src/platform/debug.cpp says what is wrong with them.
  add_compile_options(
    -gline-tables-only -fno-inline
    -fsanitize=null,bounds,integer-divide-by-zero,return -fno-sanitize-recover=all
    -fsanitize-minimal-runtime "SHELL:-include ${SITEGEN_CPP}/src/platform/checks.h")
  add_link_options(-gsource-map --profiling-funcs "SHELL:--source-map-base /")
  list(APPEND _wrapped __cxa_throw ros_fail)
endif()
if(SITEGEN_DRAFT)
  # Sources are compiled as ever, so that only the link is another when the site is built.
  add_link_options(-O1)
endif()
# Where files are on the author's computer is no business of the page's.
get_filename_component(_work "${SITEGEN_RCLCPP}/../../.." ABSOLUTE)
add_compile_options(
  "-ffile-prefix-map=${CMAKE_SOURCE_DIR}=${SITEGEN_SHOWN}" "-ffile-prefix-map=${_work}=build"
  "-ffile-prefix-map=${SITEGEN_CPP}=rclcpp" "-ffile-prefix-map=${EMSCRIPTEN_ROOT_PATH}=emscripten")
foreach(_function IN LISTS _wrapped)
  add_link_options("LINKER:--wrap=${_function}")
endforeach()
# ros_main() and the sleeps of libc are in the library, which CMake puts last.
foreach(_language C CXX)
  string(APPEND CMAKE_${_language}_STANDARD_LIBRARIES " \"${SITEGEN_RCLCPP}\"")
endforeach()
