#pragma once

#include <memory>
#include <string>

#include "rclcpp/node_interfaces/get_node_base_interface.hpp"
#include "rclcpp/generic_publisher.hpp"

namespace rclcpp
{

template<class NodeT>
std::shared_ptr<GenericPublisher> create_generic_publisher(
  NodeT && node, const std::string & topic_name, const std::string & topic_type, const QoS & qos,
  const PublisherOptionsBase & options = PublisherOptions())
{
  const auto base = node_interfaces::get_node_base_interface(node);
  auto publisher =
    std::make_shared<GenericPublisher>(*base, topic_name, topic_type, qos, options);
  base->add(detail::ExecutableKind::kWaitable, publisher->events(), options.callback_group);
  return publisher;
}

}  // namespace rclcpp
