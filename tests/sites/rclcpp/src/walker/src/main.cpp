// Opens the nodes of a tree, which are in a package that this one does not depend on.
#include <cstdio>
#include <stdexcept>

#include "behaviortree_cpp/factory.hpp"
#include "rclcpp/rclcpp.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  trees::Factory factory;
  try {
    for (const char * name : {"left_node", "right_node", "none"}) {
      factory.registerFromPlugin(std::string("lib") + name + ".so");
    }
  } catch (const std::runtime_error & error) {
    std::printf("%s\n", error.what());
  }
  for (const auto & name : factory.names) {std::printf("%s\n", name.c_str());}
}
