#include "behaviortree_cpp/factory.hpp"

// Both libraries have this function.
extern "C" const char * side(void) {return "left";}

BT_REGISTER_NODES(factory)
{
  factory.names.push_back(std::string("turn ") + side());
}
