#include "robot_nodes/common.hpp"

std::string greeting(int wheels)
{
  return "rolls on " + std::to_string(wheels);
}
