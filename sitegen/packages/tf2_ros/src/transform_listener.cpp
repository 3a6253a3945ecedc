#include "tf2_ros/transform_listener.hpp"

#include <cstdio>
#include <string>

#include "rclcpp/executors/single_threaded_executor.hpp"

namespace tf2_ros
{
namespace
{

/// Create a node with a unique name, for a listener without a node.
rclcpp::Node::SharedPtr make_node(const void * listener)
{
  char name[64];
  std::snprintf(name, sizeof(name), "transform_listener_impl_%zx",
    reinterpret_cast<std::size_t>(listener));
  rclcpp::NodeOptions options;
  options.arguments({"--ros-args", "-r", std::string("__node:=") + name});
  options.start_parameter_event_publisher(false);
  options.start_parameter_services(false);
  return rclcpp::Node::make_shared("_", options);
}

}  // namespace

TransformListener::TransformListener(
  tf2::BufferCore & buffer, bool spin_thread, bool static_only)
: buffer_(buffer), own_node_(make_node(this))
{
  listen(
    own_node_->get_node_base_interface(), spin_thread, DynamicListenerQoS(), StaticListenerQoS(),
    {}, {}, static_only);
}

TransformListener::~TransformListener()
{
  if (executor_) {executor_->cancel();}
  if (thread_.joinable()) {thread_.join();}
}

void TransformListener::listen(
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node, bool spin_thread,
  const rclcpp::QoS & qos, const rclcpp::QoS & static_qos,
  rclcpp::SubscriptionOptions options, rclcpp::SubscriptionOptions static_options,
  bool static_only)
{
  if (spin_thread) {
    group_ = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
    options.callback_group = group_;
    static_options.callback_group = group_;
  }
  const auto subscribe = [&](
    const char * topic, const rclcpp::QoS & wanted, bool is_static,
    const rclcpp::SubscriptionOptions & chosen) {
      return rclcpp::create_subscription<tf2_msgs::msg::TFMessage>(
        node, topic, wanted,
        [this, is_static](tf2_msgs::msg::TFMessage::ConstSharedPtr message) {
          subscription_callback(message, is_static);
        }, chosen);
    };
  if (!static_only) {subscription_ = subscribe("/tf", qos, false, options);}
  static_subscription_ = subscribe("/tf_static", static_qos, true, static_options);
  if (spin_thread) {
    executor_ = std::make_shared<rclcpp::executors::SingleThreadedExecutor>();
    executor_->add_callback_group(group_, node);
    thread_ = std::thread([executor = executor_]() {executor->spin();});
    buffer_.setUsingDedicatedThread(true);
  }
}

void TransformListener::subscription_callback(
  tf2_msgs::msg::TFMessage::ConstSharedPtr message, bool is_static)
{
  for (const auto & transform : message->transforms) {
    try {
      buffer_.setTransform(transform, "Authority undetectable", is_static);
    } catch (const tf2::TransformException & error) {
      RCLCPP_ERROR(
        rclcpp::get_logger("tf2_ros_transform_listener"),
        "Failure to set received transform from %s to %s with error: %s\n",
        transform.child_frame_id.c_str(), transform.header.frame_id.c_str(), error.what());
    }
  }
}

}  // namespace tf2_ros
