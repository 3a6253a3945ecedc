# Python modules of a package: sitegen reads where they are from CMakeLists.txt, and CMake has no part
# in them.
include_guard(GLOBAL)
macro(ament_python_install_package)
endmacro()
macro(ament_python_install_module)
endmacro()
macro(ament_get_python_install_dir result)
  set(${result} "python")
endmacro()
