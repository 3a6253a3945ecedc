# Python modules of a package: sitegen reads their location from CMakeLists.txt, so there is nothing
# to do for CMake.
include_guard(GLOBAL)
set(PYTHON_INSTALL_DIR python)
macro(ament_python_install_package)
endmacro()
macro(ament_python_install_module)
endmacro()
macro(ament_get_python_install_dir result)
  set(${result} "${PYTHON_INSTALL_DIR}")
endmacro()
