# The CMake package of Eigen finds its headers; this adds the variables that
# ament_target_dependencies() uses.
set(Eigen3_TARGETS Eigen3::Eigen)
set(Eigen3_LIBRARIES Eigen3::Eigen)
