#pragma once

#include <memory>
#include <string>

#include "rclcpp/node_interfaces/get_node_base_interface.hpp"
#include "rclcpp/node_interfaces/get_node_parameters_interface.hpp"
#include "rclcpp/node_interfaces/get_node_topics_interface.hpp"
#include "rclcpp/publisher.hpp"

namespace rclcpp
{

/// Without QoS overrides by parameters; these require Node::create_publisher().
template<
  class MessageT, class AllocatorT = std::allocator<void>,
  class PublisherT = Publisher<MessageT, AllocatorT>, class NodeT>
std::shared_ptr<PublisherT> create_publisher(
  NodeT && node, const std::string & topic_name, const QoS & qos,
  const PublisherOptionsWithAllocator<AllocatorT> & options =
  PublisherOptionsWithAllocator<AllocatorT>())
{
  const auto base = node_interfaces::get_node_base_interface(node);
  auto publisher = std::make_shared<PublisherT>(*base, topic_name, qos, options);
  base->add(detail::ExecutableKind::kWaitable, publisher->events(), options.callback_group);
  return publisher;
}

/// As upstream, for the interfaces of a node.
template<
  class MessageT, class AllocatorT = std::allocator<void>,
  class PublisherT = Publisher<MessageT, AllocatorT>, class NodeParametersT, class NodeTopicsT>
std::shared_ptr<PublisherT> create_publisher(
  NodeParametersT &&, NodeTopicsT && topics, const std::string & topic_name, const QoS & qos,
  const PublisherOptionsWithAllocator<AllocatorT> & options =
  PublisherOptionsWithAllocator<AllocatorT>())
{
  return create_publisher<MessageT, AllocatorT, PublisherT>(topics, topic_name, qos, options);
}

}  // namespace rclcpp
