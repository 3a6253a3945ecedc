#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "class_loader/class_loader.hpp"
#include "components/shape.hpp"
#include "pluginlib/class_loader.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/component_manager.hpp"
#include "rclcpp_components/node_factory.hpp"

using namespace composition_interfaces::srv;

/// Load and unload by the services of a container.
void manage()
{
  auto executor = std::make_shared<rclcpp::executors::SingleThreadedExecutor>();
  auto manager = std::make_shared<rclcpp_components::ComponentManager>(executor, "box");
  auto asker = rclcpp::Node::make_shared("asker");
  executor->add_node(manager);
  executor->add_node(asker);
  const auto ask = [&](auto client, auto request) {
      auto future = client->async_send_request(request);
      executor->spin_until_future_complete(future);
      return future.get();
    };
  auto load = asker->create_client<LoadNode>("/box/_container/load_node");
  auto unload = asker->create_client<UnloadNode>("/box/_container/unload_node");
  auto list = asker->create_client<ListNodes>("/box/_container/list_nodes");

  auto wanted = std::make_shared<LoadNode::Request>();
  wanted->package_name = "components";
  wanted->plugin_name = "components::FibonacciServer";
  wanted->node_name = "spare";
  wanted->node_namespace = "/deep";
  auto loaded = ask(load, wanted);
  std::printf(
    "loaded %d %s\n", static_cast<int>(loaded->unique_id), loaded->full_node_name.c_str());
  wanted->plugin_name = "components::Nothing";
  std::printf("%s\n", ask(load, wanted)->error_message.c_str());
  auto number = std::make_shared<UnloadNode::Request>();
  number->unique_id = loaded->unique_id;
  for (int i = 0; i < 2; ++i) {
    auto nodes = ask(list, std::make_shared<ListNodes::Request>());
    auto unloaded = ask(unload, number);
    std::printf(
      "%zu nodes, unloaded %d %s\n", nodes->full_node_names.size(), unloaded->success,
      unloaded->error_message.c_str());
  }
}

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
  for (const char * library : {"/opt/lib/libaction_server.so", "libnothing.so"}) {
    try {
      class_loader::ClassLoader one(library);
      std::printf("%zu\n", one.getAvailableClasses<rclcpp_components::NodeFactory>().size());
    } catch (const class_loader::LibraryLoadException & error) {
      std::printf("%s\n", error.what());
    }
  }
  // Of a package that needs this one.
  pluginlib::ClassLoader<components::Shape> shapes("components", "components::Shape");
  auto shape = shapes.createSharedInstance("round");
  shape->initialize(2);
  std::printf("round %.0f\n", shape->area());
  manage();
  executor.spin();
}
