#pragma once

#include <memory>
#include <string>
#include <utility>

#include "rclcpp/node_interfaces/get_node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_parts.hpp"
#include "rclcpp/subscription.hpp"

namespace rclcpp
{

/// `node` is a node or one of its interfaces, or a pointer to it.
template<class MessageT, class CallbackT, class NodeT>
std::shared_ptr<Subscription<MessageT>> create_subscription(
  NodeT && node, const std::string & topic, const QoS & qos, CallbackT && callback,
  const SubscriptionOptionsBase & options = SubscriptionOptions())
{
  auto base = node_interfaces::get_node_base_interface(node);
  auto subscription = std::make_shared<Subscription<MessageT>>(
    *base, topic, qos, std::forward<CallbackT>(callback), options);
  base->add(detail::ExecutableKind::kSubscription, subscription, options.callback_group);
  base->add(detail::ExecutableKind::kWaitable, subscription->events(), options.callback_group);
  return subscription;
}

}  // namespace rclcpp
