# Packages that download a library when they are built, which sitegen does not do.
include_guard(GLOBAL)
find_package(ament_cmake REQUIRED)

macro(ament_vendor target)
  cmake_parse_arguments(_ament_vendor "GLOBAL_HOOK;SKIP_INSTALL"
    "SOURCE_SUBDIR;VCS_TYPE;VCS_URL;VCS_VERSION;SATISFIED" "CMAKE_ARGS;PATCHES" ${ARGN})
  if(NOT _ament_vendor_SATISFIED)
    sitegen_refuse("downloads '${_ament_vendor_VCS_URL}' when it is built, which is not possible \
for pages; add the library to the workspace as a package")
  endif()
endmacro()
