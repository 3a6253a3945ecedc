# A part of ament_cmake.
include(CMakeFindDependencyMacro)
find_dependency(ament_cmake)
