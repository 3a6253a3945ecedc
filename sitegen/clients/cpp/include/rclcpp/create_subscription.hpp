#pragma once

#include <memory>
#include <string>
#include <utility>

#include "rclcpp/node_interfaces/get_node_base_interface.hpp"
#include "rclcpp/node_interfaces/get_node_parameters_interface.hpp"
#include "rclcpp/node_interfaces/get_node_topics_interface.hpp"
#include "rclcpp/subscription.hpp"

namespace rclcpp
{

/// Without QoS overrides by parameters; these require Node::create_subscription().
template<class MessageT, class CallbackT, class AllocatorT = std::allocator<void>, class NodeT>
std::shared_ptr<Subscription<MessageT>> create_subscription(
  NodeT && node, const std::string & topic_name, const QoS & qos, CallbackT && callback,
  const SubscriptionOptionsWithAllocator<AllocatorT> & options =
  SubscriptionOptionsWithAllocator<AllocatorT>())
{
  const auto base = node_interfaces::get_node_base_interface(node);
  auto subscription = std::make_shared<Subscription<MessageT>>(
    *base, topic_name, qos, std::forward<CallbackT>(callback), options);
  const auto statistics =
    options.topic_stats_options.state.maker(TopicStatisticsState::Disable);
  if (statistics) {subscription->observe(statistics(*base, options));}
  base->add(detail::ExecutableKind::kSubscription, subscription, options.callback_group);
  base->add(detail::ExecutableKind::kWaitable, subscription->events(), options.callback_group);
  return subscription;
}

/// As upstream, for the interfaces of a node.
template<
  class MessageT, class CallbackT, class AllocatorT = std::allocator<void>,
  class NodeParametersT, class NodeTopicsT>
std::shared_ptr<Subscription<MessageT>> create_subscription(
  NodeParametersT &&, NodeTopicsT && topics, const std::string & topic_name, const QoS & qos,
  CallbackT && callback,
  const SubscriptionOptionsWithAllocator<AllocatorT> & options =
  SubscriptionOptionsWithAllocator<AllocatorT>())
{
  return create_subscription<MessageT>(
    topics, topic_name, qos, std::forward<CallbackT>(callback), options);
}

}  // namespace rclcpp
