# A part of rosidl_default_generators.
include(CMakeFindDependencyMacro)
find_dependency(rosidl_default_generators)
