#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "composition_interfaces/srv/list_nodes.hpp"
#include "composition_interfaces/srv/load_node.hpp"
#include "composition_interfaces/srv/unload_node.hpp"
#include "rclcpp/executor.hpp"
#include "rclcpp/node.hpp"
#include "rclcpp_components/node_factory.hpp"

namespace rclcpp_components
{

class ComponentManagerException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Loads components into its executor when its services are called. All components that are linked
/// into the program are available, whatever package they belong to.
class ComponentManager : public rclcpp::Node
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ComponentManager)

  using LoadNode = composition_interfaces::srv::LoadNode;
  using UnloadNode = composition_interfaces::srv::UnloadNode;
  using ListNodes = composition_interfaces::srv::ListNodes;

  explicit ComponentManager(
    std::weak_ptr<rclcpp::Executor> executor = std::weak_ptr<rclcpp::Executor>(),
    std::string node_name = "ComponentManager",
    const rclcpp::NodeOptions & node_options = rclcpp::NodeOptions()
    .start_parameter_services(false).start_parameter_event_publisher(false));
  ~ComponentManager() override;

  virtual void set_executor(const std::weak_ptr<rclcpp::Executor> executor)
  {
    executor_ = executor;
  }
  /// Create a node of the class `plugin` and return its number. Throws ComponentManagerException.
  std::uint64_t load(const std::string & plugin, const rclcpp::NodeOptions & options);

protected:
  virtual rclcpp::NodeOptions create_node_options(
    const std::shared_ptr<LoadNode::Request> request);
  virtual void on_load_node(
    const std::shared_ptr<rmw_request_id_t> header,
    const std::shared_ptr<LoadNode::Request> request,
    std::shared_ptr<LoadNode::Response> response);
  virtual void on_unload_node(
    const std::shared_ptr<rmw_request_id_t> header,
    const std::shared_ptr<UnloadNode::Request> request,
    std::shared_ptr<UnloadNode::Response> response);
  virtual void on_list_nodes(
    const std::shared_ptr<rmw_request_id_t> header,
    const std::shared_ptr<ListNodes::Request> request,
    std::shared_ptr<ListNodes::Response> response);

  std::weak_ptr<rclcpp::Executor> executor_;
  std::uint64_t unique_id_{1};
  std::map<std::uint64_t, NodeInstanceWrapper> node_wrappers_;

private:
  std::vector<std::shared_ptr<rclcpp::ServiceBase>> services_;
};

/// The main function of component containers. After `--component`, the command line contains the
/// initial components: for each, its class, the number of its arguments, and the arguments.
int run_container(int argc, char ** argv, std::shared_ptr<rclcpp::Executor> (* make_executor)());

}  // namespace rclcpp_components
