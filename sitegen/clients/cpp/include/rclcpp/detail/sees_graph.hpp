// The methods of a node that query the graph.
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/node_interfaces/node_graph_interface.hpp"

namespace rclcpp
{
namespace detail
{

class SeesGraph
{
public:
  node_interfaces::NodeGraphInterface::SharedPtr get_node_graph_interface() const
  {
    return std::make_shared<node_interfaces::NodeGraphInterface>(base_);
  }

  std::vector<std::string> get_node_names() const {return graph().get_node_names();}
  std::map<std::string, std::vector<std::string>> get_topic_names_and_types() const
  {
    return graph().get_topic_names_and_types();
  }
  std::map<std::string, std::vector<std::string>> get_service_names_and_types() const
  {
    return graph().get_service_names_and_types();
  }
  std::map<std::string, std::vector<std::string>> get_service_names_and_types_by_node(
    const std::string & node_name, const std::string & node_namespace) const
  {
    return graph().get_service_names_and_types_by_node(node_name, node_namespace);
  }
  std::size_t count_publishers(const std::string & topic_name) const
  {
    return graph().count_publishers(topic_name);
  }
  std::size_t count_subscribers(const std::string & topic_name) const
  {
    return graph().count_subscribers(topic_name);
  }
  std::size_t count_clients(const std::string & service_name) const
  {
    return graph().count_clients(service_name);
  }
  std::size_t count_services(const std::string & service_name) const
  {
    return graph().count_services(service_name);
  }
  std::vector<TopicEndpointInfo> get_publishers_info_by_topic(
    const std::string & topic_name, bool no_mangle = false) const
  {
    return graph().get_publishers_info_by_topic(topic_name, no_mangle);
  }
  std::vector<TopicEndpointInfo> get_subscriptions_info_by_topic(
    const std::string & topic_name, bool no_mangle = false) const
  {
    return graph().get_subscriptions_info_by_topic(topic_name, no_mangle);
  }
  Event::SharedPtr get_graph_event() const {return graph().get_graph_event();}
  void wait_for_graph_change(Event::SharedPtr event, std::chrono::nanoseconds timeout) const
  {
    graph().wait_for_graph_change(std::move(event), timeout);
  }

protected:
  explicit SeesGraph(node_interfaces::NodeBaseInterface::SharedPtr base)
  : base_(std::move(base)) {}

  node_interfaces::NodeBaseInterface::SharedPtr base_;

private:
  node_interfaces::NodeGraphInterface graph() const
  {
    return node_interfaces::NodeGraphInterface(base_);
  }
};

}  // namespace detail
}  // namespace rclcpp
