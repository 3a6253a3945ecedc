#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "class_loader/class_loader.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/node_factory.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::executors::MultiThreadedExecutor executor;
  class_loader::ClassLoader loader("");
  std::vector<rclcpp_components::NodeInstanceWrapper> nodes;
  for (const auto & name : loader.getAvailableClasses<rclcpp_components::NodeFactory>()) {
    std::printf("Load %s\n", name.c_str());
    auto factory = loader.createInstance<rclcpp_components::NodeFactory>(name);
    nodes.push_back(factory->create_node_instance(rclcpp::NodeOptions()));
    executor.add_node(nodes.back().get_node_base_interface());
  }
  executor.spin();
}
