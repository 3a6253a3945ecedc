#include "rclcpp_components/component_manager.hpp"

#include <exception>
#include <functional>

#include "class_loader/class_loader.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/parameter.hpp"
#include "rclcpp/utilities.hpp"

namespace rclcpp_components
{

ComponentManager::ComponentManager(
  std::weak_ptr<rclcpp::Executor> executor, std::string node_name,
  const rclcpp::NodeOptions & node_options)
: Node(std::move(node_name), node_options), executor_(std::move(executor))
{
  using namespace std::placeholders;  // NOLINT: as upstream binds them
  services_ = {
    create_service<LoadNode>(
      "~/_container/load_node", std::bind(&ComponentManager::on_load_node, this, _1, _2, _3)),
    create_service<UnloadNode>(
      "~/_container/unload_node", std::bind(&ComponentManager::on_unload_node, this, _1, _2, _3)),
    create_service<ListNodes>(
      "~/_container/list_nodes", std::bind(&ComponentManager::on_list_nodes, this, _1, _2, _3))};
}

ComponentManager::~ComponentManager()
{
  const auto executor = executor_.lock();
  for (auto & [id, wrapper] : node_wrappers_) {
    if (executor) {executor->remove_node(wrapper.get_node_base_interface());}
  }
}

std::uint64_t ComponentManager::load(
  const std::string & plugin, const rclcpp::NodeOptions & options)
{
  class_loader::ClassLoader loader("");
  std::shared_ptr<NodeFactory> factory;
  for (const auto & name : {plugin, "rclcpp_components::NodeFactoryTemplate<" + plugin + ">"}) {
    if (!factory && loader.isClassAvailable<NodeFactory>(name)) {
      RCLCPP_INFO(get_logger(), "Found class: %s", name.c_str());
      RCLCPP_INFO(get_logger(), "Instantiate class: %s", name.c_str());
      factory = loader.createInstance<NodeFactory>(name);
    }
  }
  if (!factory) {
    RCLCPP_ERROR(
      get_logger(), "Failed to find class with the requested plugin name '%s' in the program",
      plugin.c_str());
    throw ComponentManagerException("Failed to find class with the requested plugin name.");
  }
  auto wrapper = factory->create_node_instance(options);
  const auto id = unique_id_++;
  if (const auto executor = executor_.lock()) {
    executor->add_node(wrapper.get_node_base_interface(), true);
  }
  node_wrappers_[id] = wrapper;
  return id;
}

rclcpp::NodeOptions ComponentManager::create_node_options(
  const std::shared_ptr<LoadNode::Request> request)
{
  std::vector<std::string> words = {"--ros-args"};
  const auto remap = [&words](const std::string & rule) {
      words.push_back("-r");
      words.push_back(rule);
    };
  for (const auto & rule : request->remap_rules) {remap(rule);}
  if (!request->node_name.empty()) {remap("__node:=" + request->node_name);}
  if (!request->node_namespace.empty()) {remap("__ns:=" + request->node_namespace);}
  std::vector<rclcpp::Parameter> parameters;
  for (const auto & parameter : request->parameters) {
    parameters.push_back(rclcpp::Parameter::from_parameter_msg(parameter));
  }
  auto options = rclcpp::NodeOptions()
    .use_global_arguments(false).parameter_overrides(parameters).arguments(words);
  for (const auto & message : request->extra_arguments) {
    const auto extra = rclcpp::Parameter::from_parameter_msg(message);
    if (extra.get_name() == "use_intra_process_comms") {
      if (extra.get_type() != rclcpp::ParameterType::PARAMETER_BOOL) {
        throw ComponentManagerException(
                "Extra component argument 'use_intra_process_comms' must be a boolean");
      }
      options.use_intra_process_comms(extra.as_bool());
    }
  }
  return options;
}

void ComponentManager::on_load_node(
  const std::shared_ptr<rmw_request_id_t>, const std::shared_ptr<LoadNode::Request> request,
  std::shared_ptr<LoadNode::Response> response)
{
  try {
    response->unique_id = load(request->plugin_name, create_node_options(request));
    response->full_node_name =
      node_wrappers_[response->unique_id].get_node_base_interface()->get_fully_qualified_name();
    response->success = true;
  } catch (const std::exception & error) {
    RCLCPP_ERROR(get_logger(), "%s", error.what());
    response->error_message = error.what();
    response->success = false;
  }
}

void ComponentManager::on_unload_node(
  const std::shared_ptr<rmw_request_id_t>, const std::shared_ptr<UnloadNode::Request> request,
  std::shared_ptr<UnloadNode::Response> response)
{
  const auto found = node_wrappers_.find(request->unique_id);
  response->success = found != node_wrappers_.end();
  if (!response->success) {
    response->error_message =
      "No node found with unique_id: " + std::to_string(request->unique_id);
    RCLCPP_WARN(get_logger(), "%s", response->error_message.c_str());
    return;
  }
  if (const auto executor = executor_.lock()) {
    executor->remove_node(found->second.get_node_base_interface());
  }
  node_wrappers_.erase(found);
}

void ComponentManager::on_list_nodes(
  const std::shared_ptr<rmw_request_id_t>, const std::shared_ptr<ListNodes::Request>,
  std::shared_ptr<ListNodes::Response> response)
{
  for (auto & [id, wrapper] : node_wrappers_) {
    response->unique_ids.push_back(id);
    response->full_node_names.push_back(
      wrapper.get_node_base_interface()->get_fully_qualified_name());
  }
}

int run_container(int argc, char ** argv, std::shared_ptr<rclcpp::Executor> (* make_executor)())
{
  int own = 0;
  while (own < argc && std::string(argv[own]) != "--component") {++own;}
  rclcpp::init(own, argv);
  const auto executor = make_executor();
  const auto manager = std::make_shared<ComponentManager>(executor);
  executor->add_node(manager);
  for (int at = own; at + 2 < argc; ) {
    const std::string plugin = argv[at + 1];
    const int end = at + 3 + std::stoi(argv[at + 2]);
    const std::vector<std::string> words(argv + at + 3, argv + std::min(end, argc));
    try {
      manager->load(plugin, rclcpp::NodeOptions().use_global_arguments(false).arguments(words));
    } catch (const std::exception & error) {
      RCLCPP_ERROR(
        manager->get_logger(), "Component '%s' could not be loaded: %s", plugin.c_str(),
        error.what());
    }
    at = end;
  }
  executor->spin();
  rclcpp::shutdown();
  return 0;
}

}  // namespace rclcpp_components
