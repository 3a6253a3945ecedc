#pragma once

#include <memory>
#include <string>
#include <utility>

#include "rclcpp/node_interfaces/get_node_base_interface.hpp"
#include "rclcpp/generic_subscription.hpp"

namespace rclcpp
{

template<class NodeT, class CallbackT>
std::shared_ptr<GenericSubscription> create_generic_subscription(
  NodeT && node, const std::string & topic_name, const std::string & topic_type, const QoS & qos,
  CallbackT && callback, const SubscriptionOptionsBase & options = SubscriptionOptions())
{
  const auto base = node_interfaces::get_node_base_interface(node);
  auto subscription = std::make_shared<GenericSubscription>(
    *base, topic_name, topic_type, qos, std::forward<CallbackT>(callback), options);
  base->add(detail::ExecutableKind::kSubscription, subscription, options.callback_group);
  base->add(detail::ExecutableKind::kWaitable, subscription->events(), options.callback_group);
  return subscription;
}

}  // namespace rclcpp
