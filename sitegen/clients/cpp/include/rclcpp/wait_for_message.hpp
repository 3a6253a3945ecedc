#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "rclcpp/node.hpp"
#include "rclcpp/wait_set.hpp"

namespace rclcpp
{

/// Wait for one message of `subscription` without running its callback; false on shutdown or after
/// `time_to_wait`, which is unlimited if negative.
template<class MessageT, class Rep = std::int64_t, class Period = std::milli>
bool wait_for_message(
  MessageT & out, std::shared_ptr<Subscription<MessageT>> subscription,
  std::shared_ptr<Context> context,
  std::chrono::duration<Rep, Period> time_to_wait = std::chrono::duration<Rep, Period>(-1))
{
  const auto guard = std::make_shared<GuardCondition>(context);
  const auto handle = context->add_on_shutdown_callback([guard]() {guard->trigger();});
  WaitSet wait_set({{subscription}}, {guard});
  const bool ready = wait_set.wait(time_to_wait).kind() == WaitResultKind::Ready;
  context->remove_on_shutdown_callback(handle);
  MessageInfo info;
  return ready && !guard->take() && subscription->take(out, info);
}

template<class MessageT, class Rep = std::int64_t, class Period = std::milli>
bool wait_for_message(
  MessageT & out, Node::SharedPtr node, const std::string & topic,
  std::chrono::duration<Rep, Period> time_to_wait = std::chrono::duration<Rep, Period>(-1),
  const QoS & qos = SystemDefaultsQoS())
{
  const auto subscription =
    node->create_subscription<MessageT>(topic, qos, [](std::shared_ptr<const MessageT>) {});
  return wait_for_message(
    out, subscription, node->get_node_options().context(), time_to_wait);
}

}  // namespace rclcpp
