# Eigen's own CMake package says where its headers are; this adds what ament_target_dependencies() asks.
set(Eigen3_TARGETS Eigen3::Eigen)
set(Eigen3_LIBRARIES Eigen3::Eigen)
