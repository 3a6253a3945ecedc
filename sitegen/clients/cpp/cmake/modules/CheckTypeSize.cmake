# Emscripten's module of this name runs a program to learn a size, but programs of pages run only in
# pages. That of CMake reads the size from what the compiler writes.
include("${CMAKE_ROOT}/Modules/CheckTypeSize.cmake")
