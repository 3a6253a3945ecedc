#pragma once

#include <vector>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/create_publisher.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2_msgs/msg/tf_message.hpp"
#include "tf2_ros/qos.hpp"
#include "tf2_ros/visibility_control.h"

namespace tf2_ros
{

/// Publishes static transforms on /tf_static, which is transient local.
class StaticTransformBroadcaster
{
public:
  /// `node` is a node, or a pointer to one.
  template<class NodeT, class AllocatorT = std::allocator<void>>
  explicit StaticTransformBroadcaster(
    NodeT && node, const rclcpp::QoS & qos = StaticBroadcasterQoS(),
    const rclcpp::PublisherOptionsWithAllocator<AllocatorT> & options =
    rclcpp::PublisherOptionsWithAllocator<AllocatorT>())
  : publisher_(rclcpp::create_publisher<tf2_msgs::msg::TFMessage>(
        node, "/tf_static", qos, options)) {}

  void sendTransform(const geometry_msgs::msg::TransformStamped & transform);
  void sendTransform(const std::vector<geometry_msgs::msg::TransformStamped> & transforms);

private:
  rclcpp::Publisher<tf2_msgs::msg::TFMessage>::SharedPtr publisher_;
  tf2_msgs::msg::TFMessage net_message_;  // the newest of each child
};

}  // namespace tf2_ros
