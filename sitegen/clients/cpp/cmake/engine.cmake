# How programs are compiled and linked for SITEGEN_ENGINE, "jspi" or "asyncify". CMake includes this
# file after project(), so that it applies to all targets, including those that do not use ROS.
include_guard(GLOBAL)

get_filename_component(SITEGEN_CPP "${CMAKE_CURRENT_LIST_DIR}/.." ABSOLUTE)

# What completes the compiler's own headers.
include_directories(SYSTEM "${SITEGEN_CPP}/system")
list(PREPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}/modules")

set(_settings
  MODULARIZE=1 EXPORT_ES6=1 USE_ES6_IMPORT_META=1 ENVIRONMENT=worker
  # The stack is below the data and grows towards 0: one that overflows is an access outside of the
  # memory, and overwrites no data (cppNode.js: describe). Data below 1 MiB has short addresses.
  ALLOW_MEMORY_GROWTH=1 TOTAL_STACK=917504 GLOBAL_BASE=917504 EXIT_RUNTIME=1 TEXTDECODER=2
  # The page calls ros_main(), which calls main().
  INVOKE_RUN=0 EXPORTED_FUNCTIONS=_main,_ros_main,_ros_main_pointer)
if(SITEGEN_ENGINE STREQUAL "jspi")
  # WebAssembly exceptions: with those of JavaScript, JavaScript frames would separate main() from
  # the function that waits, and the stack could not be suspended.
  set(_exceptions -fwasm-exceptions)
else()
  set(_exceptions -fexceptions)
  add_link_options("SHELL:--pre-js ${SITEGEN_CPP}/src/platform/stacks_asyncify.js")
  list(APPEND _settings ASYNCIFY=1 ASYNCIFY_IMPORTS=ros_wait ASYNCIFY_STACK_SIZE=65536)
endif()
# The defaults of g++ for a package that sets no standard; a standard that it sets takes precedence.
# Without the last option, clang 14 registers a destructor that has another type than the functions
# which exit() calls, for each constant reference to a temporary object: the program would trap.
add_compile_options(${_exceptions}
  $<$<COMPILE_LANGUAGE:CXX>:-std=gnu++17> $<$<COMPILE_LANGUAGE:CXX>:-fno-use-cxa-atexit>)
add_link_options(
  ${_exceptions} LINKER:--stack-first
  "SHELL:--js-library ${SITEGEN_CPP}/src/platform/host.js" "SHELL:--pre-js ${SITEGEN_CPP}/src/platform/host_pre.js")
foreach(_setting IN LISTS _settings)
  add_link_options("SHELL:-s ${_setting}")
endforeach()
# Threads are implemented in src/platform/threads.cpp, so the C library is never asked for them.
set(_threads
  create join detach self mutexattr_init mutexattr_settype mutex_init mutex_lock mutex_timedlock mutex_trylock mutex_unlock
  cond_init cond_wait cond_timedwait cond_signal cond_broadcast
  key_create key_delete getspecific setspecific)
list(TRANSFORM _threads PREPEND pthread_ OUTPUT_VARIABLE _wrapped)
# The keyboard is implemented in src/platform/input.cpp, the files of packages in files.cpp.
list(APPEND _wrapped
  abort __assert_fail __syscall_open __syscall_openat __wasi_fd_read fcntl poll select)
if(SITEGEN_ENGINE STREQUAL "jspi")
  list(APPEND _wrapped __cxa_get_globals __cxa_get_globals_fast)
else()
  list(APPEND _wrapped emscripten_fiber_init)
endif()
if(SITEGEN_DEBUG)
  # Function names, source lines and checks; src/platform/debug.cpp reports failed checks.
  add_compile_options(
    -gline-tables-only -fno-inline
    -fsanitize=null,bounds,integer-divide-by-zero,return -fno-sanitize-recover=all
    -fsanitize-minimal-runtime "SHELL:-include ${SITEGEN_CPP}/src/platform/checks.h")
  add_link_options(-gsource-map --profiling-funcs "SHELL:--source-map-base /")
  list(APPEND _wrapped __cxa_throw ros_fail)
endif()
if(SITEGEN_DRAFT)
  # Sources are compiled as usual, so that only the link step differs from that of a published site.
  add_link_options(-O1)
endif()
# The paths on the author's computer must not be published.
get_filename_component(_work "${SITEGEN_RCLCPP}/../../.." ABSOLUTE)
add_compile_options(
  "-ffile-prefix-map=${CMAKE_SOURCE_DIR}=${SITEGEN_SHOWN}" "-ffile-prefix-map=${_work}=build"
  "-ffile-prefix-map=${SITEGEN_CPP}=rclcpp" "-ffile-prefix-map=${EMSCRIPTEN_ROOT_PATH}=emscripten")
foreach(_function IN LISTS _wrapped)
  add_link_options("LINKER:--wrap=${_function}")
endforeach()
foreach(_language C CXX)
  # ros_main() and the sleep functions are in the library, which CMake puts last.
  string(APPEND CMAKE_${_language}_STANDARD_LIBRARIES " \"${SITEGEN_RCLCPP}\"")
  if(CMAKE_${_language}_LINK_EXECUTABLE)
    string(PREPEND CMAKE_${_language}_LINK_EXECUTABLE "${SITEGEN_LINK_LAUNCHER} ")
  endif()
endforeach()
if(NOT CMAKE_SOURCE_DIR STREQUAL SITEGEN_CPP)  # a package, and not the library
  include("${CMAKE_CURRENT_LIST_DIR}/finish.cmake")
  include("${CMAKE_CURRENT_LIST_DIR}/libraries.cmake")
  cmake_language(DEFER DIRECTORY "${CMAKE_SOURCE_DIR}" CALL sitegen_finish)
endif()
