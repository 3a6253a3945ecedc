#pragma once

#include <memory>
#include <thread>
#include <utility>

#include "rclcpp/create_subscription.hpp"
#include "rclcpp/node_interfaces/get_node_base_interface.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2/buffer_core.hpp"
#include "tf2/time.hpp"
#include "tf2_msgs/msg/tf_message.hpp"
#include "tf2_ros/qos.hpp"
#include "tf2_ros/visibility_control.h"

namespace tf2_ros
{

namespace detail
{

template<class AllocatorT = std::allocator<void>>
rclcpp::SubscriptionOptionsWithAllocator<AllocatorT> get_default_transform_listener_sub_options()
{
  return {};
}

template<class AllocatorT = std::allocator<void>>
rclcpp::SubscriptionOptionsWithAllocator<AllocatorT>
get_default_transform_listener_static_sub_options()
{
  return {};
}

}  // namespace detail

/// Fills a buffer from /tf and /tf_static.
class TransformListener
{
public:
  /// Subscribe with a node of its own.
  explicit TransformListener(
    tf2::BufferCore & buffer, bool spin_thread = true, bool static_only = false);

  /// `node` is a node, or a pointer to one. Without `spin_thread`, the caller must spin the node.
  template<class NodeT, class = std::enable_if_t<!std::is_same_v<std::decay_t<NodeT>, bool>>>
  TransformListener(
    tf2::BufferCore & buffer, NodeT && node, bool spin_thread = true,
    const rclcpp::QoS & qos = DynamicListenerQoS(),
    const rclcpp::QoS & static_qos = StaticListenerQoS(),
    const rclcpp::SubscriptionOptions & options =
    detail::get_default_transform_listener_sub_options(),
    const rclcpp::SubscriptionOptions & static_options =
    detail::get_default_transform_listener_static_sub_options(),
    bool static_only = false)
  : buffer_(buffer)
  {
    listen(
      rclcpp::node_interfaces::get_node_base_interface(node), spin_thread, qos, static_qos,
      options, static_options, static_only);
  }

  /// With individual interfaces in place of a node.
  TransformListener(
    tf2::BufferCore & buffer, rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base,
    rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr,
    rclcpp::node_interfaces::NodeParametersInterface::SharedPtr,
    rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr, bool spin_thread = true,
    const rclcpp::QoS & qos = DynamicListenerQoS(),
    const rclcpp::QoS & static_qos = StaticListenerQoS(),
    const rclcpp::SubscriptionOptions & options =
    detail::get_default_transform_listener_sub_options(),
    const rclcpp::SubscriptionOptions & static_options =
    detail::get_default_transform_listener_static_sub_options(),
    bool static_only = false)
  : buffer_(buffer)
  {
    listen(node_base, spin_thread, qos, static_qos, options, static_options, static_only);
  }

  virtual ~TransformListener();

  virtual void subscription_callback(
    tf2_msgs::msg::TFMessage::ConstSharedPtr message, bool is_static);

private:
  void listen(
    rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node, bool spin_thread,
    const rclcpp::QoS & qos, const rclcpp::QoS & static_qos,
    rclcpp::SubscriptionOptions options, rclcpp::SubscriptionOptions static_options,
    bool static_only);

  tf2::BufferCore & buffer_;
  rclcpp::Node::SharedPtr own_node_;
  rclcpp::CallbackGroup::SharedPtr group_;
  rclcpp::Subscription<tf2_msgs::msg::TFMessage>::SharedPtr subscription_;
  rclcpp::Subscription<tf2_msgs::msg::TFMessage>::SharedPtr static_subscription_;
  rclcpp::Executor::SharedPtr executor_;
  std::thread thread_;
};

/// Fills a buffer from /tf_static only.
class StaticTransformListener : public TransformListener
{
public:
  explicit StaticTransformListener(tf2::BufferCore & buffer, bool spin_thread = true)
  : TransformListener(buffer, spin_thread, true) {}

  template<class NodeT, class = std::enable_if_t<!std::is_same_v<std::decay_t<NodeT>, bool>>>
  StaticTransformListener(
    tf2::BufferCore & buffer, NodeT && node, bool spin_thread = true,
    const rclcpp::QoS & static_qos = StaticListenerQoS(),
    const rclcpp::SubscriptionOptions & static_options =
    detail::get_default_transform_listener_static_sub_options())
  : TransformListener(
      buffer, node, spin_thread, DynamicListenerQoS(), static_qos, rclcpp::SubscriptionOptions(),
      static_options, true) {}
};

}  // namespace tf2_ros
