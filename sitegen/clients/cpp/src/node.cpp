#include "rclcpp/node.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "rclcpp/detail/arguments.hpp"
#include "rclcpp/detail/host.h"
#include "rclcpp/logging.hpp"

namespace rclcpp
{

namespace
{

using rosidl_typesupport_sitegen_cpp::MessageMembers;

std::int32_t create(
  std::int32_t kind, const node_interfaces::NodeBaseInterface & node, const std::string & topic,
  const MessageMembers & type, const QoS & qos)
{
  const std::int32_t flags =
    (qos.reliability() == ReliabilityPolicy::BestEffort ? 0 : ROS_RELIABLE) |
    (qos.durability() == DurabilityPolicy::TransientLocal ? ROS_TRANSIENT_LOCAL : 0) |
    (qos.history() == HistoryPolicy::KeepAll ? ROS_KEEP_ALL : 0);
  return ros_create(
    kind, node.get_fully_qualified_name(), topic.c_str(), type.name,
    static_cast<std::int32_t>(qos.depth()), flags);
}

std::string with_slash(const std::string & name_space)
{
  return name_space.empty() || name_space[0] != '/' ? "/" + name_space : name_space;
}

/// The logger of a node is named by its full name, with dots.
std::string logger_name(std::string full_name)
{
  std::replace(full_name.begin(), full_name.end(), '/', '.');
  return full_name.substr(1);
}

std::int64_t nanoseconds(double milliseconds)
{
  return static_cast<std::int64_t>(std::llround(milliseconds * 1e6));
}

}  // namespace

namespace node_interfaces
{

NodeBaseInterface::NodeBaseInterface(const std::string & name, const std::string & name_space)
: name_(detail::remap_node(detail::arguments(), name, "__node", name)),
  namespace_(
    with_slash(detail::remap_node(detail::arguments(), name, "__ns", name_space))),
  full_name_((namespace_ == "/" ? "/" : namespace_ + "/") + name_),
  id_(ros_create(ROS_NODE, full_name_.c_str(), "", "", 0, 0))
{
}

NodeBaseInterface::~NodeBaseInterface() {ros_destroy(id_);}

std::string NodeBaseInterface::resolve(const std::string & topic) const
{
  return detail::resolve_topic(detail::arguments(), name_, namespace_, topic);
}

}  // namespace node_interfaces

Node::Node(const std::string & name, const NodeOptions & options)
: Node(name, "", options)
{
}

Node::Node(const std::string & name, const std::string & name_space, const NodeOptions &)
: base_(std::make_shared<node_interfaces::NodeBaseInterface>(name, name_space)),
  logger_(logger_name(base_->get_fully_qualified_name())),
  clock_(std::make_shared<Clock>(RCL_ROS_TIME))
{
}

PublisherBase::PublisherBase(
  const node_interfaces::NodeBaseInterface & node, const std::string & topic,
  const MessageMembers & type, const QoS & qos)
: type_(type), topic_(node.resolve(topic)), qos_(qos),
  id_(create(ROS_PUBLISHER, node, topic_, type, qos))
{
}

PublisherBase::~PublisherBase() {ros_destroy(id_);}

std::size_t PublisherBase::get_subscription_count() const
{
  return static_cast<std::size_t>(ros_matched(id_));
}

void PublisherBase::publish_message(const void * message)
{
  // One buffer for all publishers: the host copies at once.
  static std::vector<std::uint8_t> buffer;
  const std::size_t size = serialized_size(type_, message);
  if (buffer.size() < size) {buffer.resize(size);}
  serialize(type_, message, buffer.data());
  ros_publish(id_, buffer.data(), static_cast<std::uint32_t>(size));
}

void PublisherBase::publish_bytes(const SerializedMessage & bytes)
{
  const auto & message = bytes.get_rcl_serialized_message();
  ros_publish(id_, message.buffer, static_cast<std::uint32_t>(message.buffer_length));
}

SubscriptionBase::SubscriptionBase(
  const node_interfaces::NodeBaseInterface & node, const std::string & topic,
  const MessageMembers & type, const QoS & qos)
: type_(type), topic_(node.resolve(topic)), qos_(qos),
  id_(create(ROS_SUBSCRIPTION, node, topic_, type, qos))
{
}

SubscriptionBase::~SubscriptionBase() {ros_destroy(id_);}

std::size_t SubscriptionBase::get_publisher_count() const
{
  return static_cast<std::size_t>(ros_matched(id_));
}

bool SubscriptionBase::execute_one()
{
  ros_message_info from;
  const std::int32_t size = ros_next(id_, &from);
  if (size < 0) {return false;}
  SerializedMessage bytes;
  ros_take(id_, bytes.resize(static_cast<std::size_t>(size)));
  rmw_message_info_t info{};
  info.source_timestamp = nanoseconds(from.source_timestamp);
  info.received_timestamp = nanoseconds(from.received_timestamp);
  info.publication_sequence_number = from.sequence;
  info.reception_sequence_number = ++received_;
  info.publisher_gid.implementation_identifier =
    rosidl_typesupport_sitegen_cpp::typesupport_identifier;
  std::memcpy(info.publisher_gid.data, &from.publisher, sizeof(from.publisher));
  handle(std::move(bytes), MessageInfo(info));
  return true;
}

bool SubscriptionBase::decode(const SerializedMessage & bytes, void * message) const
{
  const auto & raw = bytes.get_rcl_serialized_message();
  const bool fits = deserialize(type_, message, raw.buffer, raw.buffer_length);
  if (!fits) {
    RCLCPP_ERROR(
      get_logger("rclcpp"), "a message of %zu bytes on '%s' is not a %s: it was dropped",
      raw.buffer_length, topic_.c_str(), type_.name);
  }
  return fits;
}

}  // namespace rclcpp
