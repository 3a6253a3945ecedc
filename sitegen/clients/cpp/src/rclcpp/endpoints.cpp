// Publishers, subscriptions, services and clients: the parts that do not depend on message types.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "endpoint_qos.hpp"
#include "rclcpp/client.hpp"
#include "rclcpp/detail/host.h"
#include "rclcpp/detail/platform.hpp"
#include "rclcpp/detail/stacks.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp/utilities.hpp"

namespace rclcpp
{

namespace
{

// How long a publisher with history KEEP_ALL waits for its subscriptions (ms). Fast DDS waits 100, but
// a browser shares the processor with other tabs.
constexpr double kMaxBlocking = 1000;

// ok() may yield to the event loop, and events that arrive there would not end the following wait.
bool is_valid() {return contexts::get_global_default_context()->is_valid();}

/// Reject a strict requirement: there is no network.
void refuse_network_flow(rmw_unique_network_flow_endpoints_requirement_t required, const char * what)
{
  if (required == RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_STRICTLY_REQUIRED) {
    throw exceptions::RCLError(
            std::string("could not create ") + what +
            ": strict requirement on unique network flow endpoints not supported");
  }
}

std::shared_ptr<const node_interfaces::NodeBaseInterface> living(
  const std::weak_ptr<const node_interfaces::NodeBaseInterface> & node)
{
  const auto found = node.lock();
  if (!found) {throw exceptions::RCLError("the node has been destroyed");}
  return found;
}

}  // namespace

namespace detail
{

namespace
{

// A gid is the number of the process times this, plus that of the endpoint: gidOf in protocol.js.
constexpr double kProcess = 4294967296.0;
// Larger buffers (bytes) are released after use.
constexpr std::size_t kLarge = 1024 * 1024;

rmw_request_id_t id_of(const rmw_message_info_t & info, double writer_gid)
{
  rmw_request_id_t id{};
  std::memcpy(id.writer_guid, &writer_gid, sizeof(writer_gid));
  id.sequence_number = static_cast<std::int64_t>(info.publication_sequence_number);
  return id;
}

rmw_gid_t rmw_gid(double number)
{
  rmw_gid_t gid{rosidl_typesupport_sitegen_cpp::typesupport_identifier, {}};
  std::memcpy(gid.data, &number, sizeof(number));
  return gid;
}

}  // namespace

Endpoint::Endpoint(
  std::int32_t kind, const node_interfaces::NodeBaseInterface & node, const std::string & name,
  const std::string & type, const QoS & qos)
: name_(
    node.resolve(
      name, kind == ROS_SERVICE || kind == ROS_CLIENT ? NameKind::Service : NameKind::Topic)),
  qos_(settled(kind, qos)), id_(0)
{
  const ros_qos policies = host_qos(qos_);
  id_ = ros_create(
    kind, node.get_fully_qualified_name(), name_.c_str(), type.c_str(), &policies);
}

Endpoint::~Endpoint() {ros_destroy(id_);}

std::size_t Endpoint::matched() const {return static_cast<std::size_t>(ros_matched(id_));}

rmw_gid_t Endpoint::gid() const {return rmw_gid(ros_gid(id_));}

bool Endpoint::is_local(double gid) const
{
  return std::floor(gid / kProcess) == std::floor(ros_gid(id_) / kProcess);
}

bool Receiver::execute_one()
{
  SerializedMessage bytes;
  rmw_message_info_t info;
  double writer_gid;
  if (!take_bytes(bytes, info, writer_gid)) {return false;}
  handle(bytes, info, writer_gid);
  return true;
}

bool Receiver::is_ready() const
{
  ros_message_info from;
  return ros_next(id(), &from) >= 0;
}

bool Receiver::take_bytes(SerializedMessage & bytes, rmw_message_info_t & info, double & writer_gid)
{
  ros_message_info from;
  do {
    const std::int32_t size = ros_next(id(), &from);
    if (size < 0) {return false;}
    ros_take(id(), bytes.resize(static_cast<std::size_t>(size)));
  } while (ignores_local_ && is_local(from.writer_gid));
  info = {};
  info.source_timestamp = detail::nanoseconds(from.source_timestamp);
  info.received_timestamp = detail::nanoseconds(from.received_timestamp);
  info.publication_sequence_number = from.sequence;
  info.reception_sequence_number = ++received_;
  info.publisher_gid = rmw_gid(from.writer_gid);
  writer_gid = from.writer_gid;
  return true;
}

bool Receiver::take_message(
  const MessageMembers & type, void * message, rmw_request_id_t & request_id)
{
  SerializedMessage bytes;
  rmw_message_info_t info;
  double writer_gid;
  if (!take_bytes(bytes, info, writer_gid)) {return false;}
  request_id = id_of(info, writer_gid);
  return decode(type, bytes, message);
}

bool Receiver::decode(
  const MessageMembers & type, const SerializedMessage & bytes, void * message) const
{
  const auto & raw = bytes.get_rcl_serialized_message();
  const bool fits = deserialize(type, message, raw.buffer, raw.buffer_length);
  if (!fits) {
    RCLCPP_ERROR(
      Logger("rclcpp"), "dropped %zu bytes on '%s': not a valid %s",
      raw.buffer_length, name().c_str(), type.name);
  }
  return fits;
}

Bytes encode(const MessageMembers & type, const void * message)
{
  // A shared buffer: the host copies it immediately.
  static std::vector<std::uint8_t> buffer;
  const std::size_t size = serialized_size(type, message);
  if (buffer.size() < size) {
    buffer.resize(size);
  } else if (buffer.size() > kLarge && size <= kLarge) {
    buffer = std::vector<std::uint8_t>(size);
  }
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
  const detail::MessageMembers & type, const QoS & qos, const PublisherOptionsBase & options)
: type_(type), endpoint_(ROS_PUBLISHER, node, topic, type.name, qos),
  events_(
    std::make_shared<detail::Events>(
      endpoint_.id(), options.event_callbacks, options.use_default_callbacks,
      detail::logger_name(node.get_fully_qualified_name()), endpoint_.name())),
  intra_process_(options.use_intra_process_comm),
  shares_(intra_process_ == IntraProcessSetting::Enable)
{
  refuse_network_flow(options.require_unique_network_flow_endpoints, "publisher");
}

void PublisherBase::share(std::shared_ptr<detail::intra_process::Message> message)
{
  const double gid = ros_gid(endpoint_.id());
  if (!shared_) {
    shared_ = std::shared_ptr<void>(nullptr, [gid](void *) {detail::intra_process::forget(gid);});
  }
  const std::size_t depth = std::max<std::size_t>(endpoint_.qos().depth(), 1);
  const auto subscriptions = detail::intra_process::subscriptions(endpoint_.name());
  detail::intra_process::put(gid, sent_, std::move(message), subscriptions, depth);
}

bool PublisherBase::assert_liveliness() const
{
  ros_assert(endpoint_.id());
  return true;
}

void PublisherBase::publish_message(const void * message)
{
  const auto bytes = detail::encode(type_, message);
  send(bytes.data, bytes.size);
}

void PublisherBase::publish_bytes(const SerializedMessage & bytes)
{
  const auto & message = bytes.get_rcl_serialized_message();
  send(message.buffer, static_cast<std::uint32_t>(message.buffer_length));
}

void PublisherBase::send(const std::uint8_t * data, std::uint32_t size)
{
  detail::sent();
  if (ros_publish(endpoint_.id(), data, size)) {
    ++sent_;
    return;
  }
  // Copy the message: another thread may use the shared buffer during the wait.
  const std::vector<std::uint8_t> kept(data, data + size);
  const double end = detail::now() + kMaxBlocking;
  do {
    const double left = end - detail::now();
    if (left <= 0) {
      throw exceptions::RCLError(
              std::string("failed to publish message: the queues of the subscriptions to '") +
              get_topic_name() + "' are full");
    }
    detail::wait(left);
  } while (!ros_publish(endpoint_.id(), kept.data(), size));
  ++sent_;
}

bool PublisherBase::wait_until_sent(double milliseconds) const
{
  const double end = detail::now() + milliseconds;
  while (ros_behind(endpoint_.id())) {
    const double left = end - detail::now();
    if (!is_valid() || (milliseconds >= 0 && left <= 0)) {return false;}
    detail::wait(milliseconds < 0 ? -1 : left);
  }
  return true;
}

SubscriptionBase::SubscriptionBase(
  const node_interfaces::NodeBaseInterface & node, const std::string & topic,
  const detail::MessageMembers & type, const QoS & qos, const SubscriptionOptionsBase & options)
: Receiver(ROS_SUBSCRIPTION, node, topic, type.name, qos), type_(type),
  events_(
    std::make_shared<detail::Events>(
      id(), options.event_callbacks, options.use_default_callbacks,
      detail::logger_name(node.get_fully_qualified_name()), name())),
  intra_process_(options.use_intra_process_comm)
{
  refuse_network_flow(options.require_unique_network_flow_endpoints, "subscription");
  ignores_local_ = options.ignore_local_publications;
  share(intra_process_ == IntraProcessSetting::Enable);
  if (!options.content_filter_options.filter_expression.empty()) {
    filter(options.content_filter_options, "could not create subscription");
  }
}

SubscriptionBase::~SubscriptionBase() {share(false);}

void SubscriptionBase::share(bool shares)
{
  if (shares != shares_) {detail::intra_process::subscribe(name(), shares);}
  shares_ = shares;
}

void SubscriptionBase::set_content_filter(
  const std::string & expression, const std::vector<std::string> & parameters)
{
  filter({expression, parameters}, "failed to set cft expression parameters");
}

ContentFilterOptions SubscriptionBase::get_content_filter() const
{
  if (!is_cft_enabled()) {
    throw exceptions::RCLError("failed to get cft expression parameters: no filter is set");
  }
  return filter_;
}

void SubscriptionBase::filter(const ContentFilterOptions & options, const std::string & what)
{
  std::string parameters;
  for (const auto & parameter : options.expression_parameters) {
    parameters.append(parameter.c_str(), parameter.size() + 1);
  }
  char problem[256];
  const auto ask = [&] {
      return ros_filter(
        id(), type_.definition, options.filter_expression.c_str(), parameters.c_str(),
        static_cast<std::int32_t>(options.expression_parameters.size()), problem, sizeof(problem));
    };
  std::int32_t size;
  while ((size = ask()) < 0) {detail::wait(-1);}
  if (size) {
    throw exceptions::RCLError(
            what + ": " + std::string(problem, static_cast<std::size_t>(size)));
  }
  filter_ = options;
}

ServiceBase::ServiceBase(
  const node_interfaces::NodeBaseInterface & node, const std::string & name,
  const detail::MessageMembers & request, const QoS & qos)
: Receiver(ROS_SERVICE, node, name, detail::service_type(request), qos),
  node_(node.weak_from_this())
{
}

std::shared_ptr<const node_interfaces::NodeBaseInterface> ServiceBase::node() const
{
  return living(node_);
}

std::shared_ptr<rmw_request_id_t> ServiceBase::request_id(
  const rmw_message_info_t & info, double writer_gid)
{
  return std::make_shared<rmw_request_id_t>(detail::id_of(info, writer_gid));
}

bool ServiceBase::take_type_erased_request(void * request, rmw_request_id_t & request_id)
{
  return take_message(request_type(), request, request_id);
}

void ServiceBase::respond(
  const rmw_request_id_t & to, const detail::MessageMembers & type, const void * response)
{
  double client_gid;
  std::memcpy(&client_gid, to.writer_guid, sizeof(client_gid));
  const auto bytes = detail::encode(type, response);
  const auto sequence = static_cast<std::uint32_t>(to.sequence_number);
  detail::sent();
  ros_respond(id(), client_gid, sequence, bytes.data, bytes.size);
}

ClientBase::ClientBase(
  const node_interfaces::NodeBaseInterface & node, const std::string & name,
  const detail::MessageMembers & request, const QoS & qos)
: Receiver(ROS_CLIENT, node, name, detail::service_type(request), qos),
  node_(node.weak_from_this())
{
}

std::shared_ptr<const node_interfaces::NodeBaseInterface> ClientBase::node() const
{
  return living(node_);
}

bool ClientBase::take_type_erased_response(void * response, rmw_request_id_t & request_header)
{
  if (!take_message(response_type(), response, request_header)) {return false;}
  // The header of a response names the client.
  std::memcpy(request_header.writer_guid, gid().data, sizeof(request_header.writer_guid));
  return true;
}

std::int64_t ClientBase::send(const detail::MessageMembers & type, const void * request)
{
  const auto bytes = detail::encode(type, request);
  detail::sent();
  return ros_request(id(), bytes.data, bytes.size);
}

bool ClientBase::wait(double milliseconds)
{
  const double end = detail::now() + milliseconds;
  while (!service_is_ready()) {
    const double left = end - detail::now();
    if (!is_valid() || (milliseconds >= 0 && left <= 0)) {return false;}
    detail::wait(milliseconds < 0 ? -1 : left);
  }
  return true;
}

}  // namespace rclcpp
