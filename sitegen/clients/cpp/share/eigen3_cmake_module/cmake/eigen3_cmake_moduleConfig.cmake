# The CMake package of Eigen finds its headers; this adds the variables that
# ament_target_dependencies() and packages use.
set(Eigen3_TARGETS Eigen3::Eigen)
set(Eigen3_LIBRARIES Eigen3::Eigen)
set(Eigen3_INCLUDE_DIRS "${SITEGEN_HEADERS}/eigen3")
set(Eigen3_INCLUDE_DIR "${Eigen3_INCLUDE_DIRS}")
