// Publishers, subscriptions, services and clients, as far as their types do not matter.
#include <cmath>
#include <cstring>
#include <limits>

#include "rclcpp/client.hpp"
#include "rclcpp/detail/host.h"
#include "rclcpp/detail/platform.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp/utilities.hpp"

namespace rclcpp
{

namespace detail
{

namespace
{

ros_qos host_qos(const QoS & qos)
{
  const double never = std::numeric_limits<double>::infinity();
  const std::int32_t flags = (qos.reliability() == ReliabilityPolicy::BestEffort ? 0 : ROS_RELIABLE) |
         (qos.durability() == DurabilityPolicy::TransientLocal ? ROS_TRANSIENT_LOCAL : 0) |
         (qos.history() == HistoryPolicy::KeepAll ? ROS_KEEP_ALL : 0);
  return {never, never, never, static_cast<std::int32_t>(qos.depth()), flags};
}

std::int64_t nanoseconds(double milliseconds)
{
  return static_cast<std::int64_t>(std::llround(milliseconds * 1e6));
}

}  // namespace

Endpoint::Endpoint(
  std::int32_t kind, const node_interfaces::NodeBaseInterface & node, const std::string & name,
  const std::string & type, const QoS & qos)
: name_(node.resolve(name)), qos_(qos),
  id_(0)
{
  const ros_qos policies = host_qos(qos);
  id_ = ros_create(
    kind, node.get_fully_qualified_name(), name_.c_str(), type.c_str(), &policies);
}

Endpoint::~Endpoint() {ros_destroy(id_);}

std::size_t Endpoint::matched() const {return static_cast<std::size_t>(ros_matched(id_));}

bool Receiver::execute_one()
{
  ros_message_info from;
  const std::int32_t size = ros_next(id(), &from);
  if (size < 0) {return false;}
  SerializedMessage bytes;
  ros_take(id(), bytes.resize(static_cast<std::size_t>(size)));
  rmw_message_info_t info{};
  info.source_timestamp = nanoseconds(from.source_timestamp);
  info.received_timestamp = nanoseconds(from.received_timestamp);
  info.publication_sequence_number = from.sequence;
  info.reception_sequence_number = ++received_;
  info.publisher_gid.implementation_identifier =
    rosidl_typesupport_sitegen_cpp::typesupport_identifier;
  std::memcpy(info.publisher_gid.data, &from.writer, sizeof(from.writer));
  handle(bytes, info, from.writer);
  return true;
}

bool Receiver::decode(
  const MessageMembers & type, const SerializedMessage & bytes, void * message) const
{
  const auto & raw = bytes.get_rcl_serialized_message();
  const bool fits = deserialize(type, message, raw.buffer, raw.buffer_length);
  if (!fits) {
    RCLCPP_ERROR(
      get_logger("rclcpp"), "a message of %zu bytes on '%s' is not a %s: it was dropped",
      raw.buffer_length, name().c_str(), type.name);
  }
  return fits;
}

Bytes encode(const MessageMembers & type, const void * message)
{
  // One buffer for all: the host copies at once.
  static std::vector<std::uint8_t> buffer;
  const std::size_t size = serialized_size(type, message);
  if (buffer.size() < size) {buffer.resize(size);}
  serialize(type, message, buffer.data());
  return {buffer.data(), static_cast<std::uint32_t>(size)};
}

std::string service_type(const MessageMembers & request)
{
  const std::string name = request.name;
  return name.substr(0, name.rfind("_Request"));
}

}  // namespace detail

PublisherBase::PublisherBase(
  const node_interfaces::NodeBaseInterface & node, const std::string & topic,
  const detail::MessageMembers & type, const QoS & qos)
: type_(type), endpoint_(ROS_PUBLISHER, node, topic, type.name, qos)
{
}

void PublisherBase::publish_message(const void * message)
{
  const auto bytes = detail::encode(type_, message);
  ros_publish(endpoint_.id(), bytes.data, bytes.size);
}

void PublisherBase::publish_bytes(const SerializedMessage & bytes)
{
  const auto & message = bytes.get_rcl_serialized_message();
  ros_publish(endpoint_.id(), message.buffer, static_cast<std::uint32_t>(message.buffer_length));
}

SubscriptionBase::SubscriptionBase(
  const node_interfaces::NodeBaseInterface & node, const std::string & topic,
  const detail::MessageMembers & type, const QoS & qos)
: Receiver(ROS_SUBSCRIPTION, node, topic, type.name, qos), type_(type)
{
}

ServiceBase::ServiceBase(
  const node_interfaces::NodeBaseInterface & node, const std::string & name,
  const detail::MessageMembers & request, const QoS & qos)
: Receiver(ROS_SERVICE, node, name, detail::service_type(request), qos)
{
}

void ServiceBase::respond(
  const rmw_request_id_t & to, const detail::MessageMembers & type, const void * response)
{
  double writer;
  std::memcpy(&writer, to.writer_guid, sizeof(writer));
  const auto bytes = detail::encode(type, response);
  const auto sequence = static_cast<std::uint32_t>(to.sequence_number);
  ros_respond(id(), writer, sequence, bytes.data, bytes.size);
}

ClientBase::ClientBase(
  const node_interfaces::NodeBaseInterface & node, const std::string & name,
  const detail::MessageMembers & request, const QoS & qos)
: Receiver(ROS_CLIENT, node, name, detail::service_type(request), qos)
{
}

std::int64_t ClientBase::send(const detail::MessageMembers & type, const void * request)
{
  const auto bytes = detail::encode(type, request);
  return ros_request(id(), bytes.data, bytes.size);
}

bool ClientBase::wait(double milliseconds)
{
  const double end = detail::now() + milliseconds;
  while (!service_is_ready()) {
    const double left = end - detail::now();
    if (!ok() || (milliseconds >= 0 && left <= 0)) {return false;}
    detail::wait(milliseconds < 0 ? -1 : left);
  }
  return true;
}

}  // namespace rclcpp
