#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "rclcpp/event.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/qos.hpp"
#include "rmw/types.h"
#include "rosidl_runtime_c/type_hash.h"

namespace rclcpp
{

enum class EndpointType {Invalid = 0, Publisher = 1, Subscription = 2};

/// A publisher or a subscription in the graph.
class TopicEndpointInfo
{
public:
  using Gid = std::array<std::uint8_t, RMW_GID_STORAGE_SIZE>;

  TopicEndpointInfo(
    std::string node_name, std::string node_namespace, std::string topic_type,
    EndpointType endpoint_type, const Gid & gid, const QoS & qos)
  : node_name_(std::move(node_name)), node_namespace_(std::move(node_namespace)),
    topic_type_(std::move(topic_type)), endpoint_type_(endpoint_type), gid_(gid), qos_(qos) {}

  std::string & node_name() {return node_name_;}
  const std::string & node_name() const {return node_name_;}
  std::string & node_namespace() {return node_namespace_;}
  const std::string & node_namespace() const {return node_namespace_;}
  std::string & topic_type() {return topic_type_;}
  const std::string & topic_type() const {return topic_type_;}
  EndpointType & endpoint_type() {return endpoint_type_;}
  const EndpointType & endpoint_type() const {return endpoint_type_;}
  Gid & endpoint_gid() {return gid_;}
  const Gid & endpoint_gid() const {return gid_;}
  /// The depth is not announced in the graph; it is 0, as with DDS.
  QoS & qos_profile() {return qos_;}
  const QoS & qos_profile() const {return qos_;}
  /// Its version is 0: the graph identifies types by name only.
  rosidl_type_hash_t & topic_type_hash() {return hash_;}
  const rosidl_type_hash_t & topic_type_hash() const {return hash_;}

private:
  std::string node_name_;
  std::string node_namespace_;
  std::string topic_type_;
  EndpointType endpoint_type_;
  Gid gid_;
  QoS qos_;
  rosidl_type_hash_t hash_{};
};

namespace node_interfaces
{

/// Queries of the graph. The first query of a program waits until the page has sent the graph.
class NodeGraphInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeGraphInterface)

  /// Topics and their types.
  using NamesAndTypes = std::map<std::string, std::vector<std::string>>;
  using EndpointInfos = std::vector<TopicEndpointInfo>;

  explicit NodeGraphInterface(NodeBaseInterface::SharedPtr base)
  : base_(std::move(base)) {}
  NodeBaseInterface::SharedPtr get_node_base_interface() const {return base_;}

  /// With `no_demangle`, the names of DDS, which include the topics of services.
  NamesAndTypes get_topic_names_and_types(bool no_demangle = false) const;
  NamesAndTypes get_service_names_and_types() const;
  /// These throw RCLError if the node does not exist.
  NamesAndTypes get_service_names_and_types_by_node(
    const std::string & node_name, const std::string & node_namespace) const;
  NamesAndTypes get_client_names_and_types_by_node(
    const std::string & node_name, const std::string & node_namespace) const;
  NamesAndTypes get_publisher_names_and_types_by_node(
    const std::string & node_name, const std::string & node_namespace,
    bool no_demangle = false) const;
  NamesAndTypes get_subscriber_names_and_types_by_node(
    const std::string & node_name, const std::string & node_namespace,
    bool no_demangle = false) const;

  /// Full names, sorted.
  std::vector<std::string> get_node_names() const;
  std::vector<std::pair<std::string, std::string>> get_node_names_and_namespaces() const;
  std::vector<std::tuple<std::string, std::string, std::string>>
  get_node_names_with_enclaves() const;

  std::size_t count_publishers(const std::string & topic_name) const;
  std::size_t count_subscribers(const std::string & topic_name) const;
  std::size_t count_clients(const std::string & service_name) const;
  std::size_t count_services(const std::string & service_name) const;

  /// With `no_mangle`, `topic_name` is the name in DDS: `rt/chatter`.
  EndpointInfos get_publishers_info_by_topic(
    const std::string & topic_name, bool no_mangle = false) const;
  EndpointInfos get_subscriptions_info_by_topic(
    const std::string & topic_name, bool no_mangle = false) const;

  /// An event that is set by changes of the graph.
  Event::SharedPtr get_graph_event() const;
  /// Wait until `event` is set; throws InvalidEventError if it is null.
  void wait_for_graph_change(Event::SharedPtr event, std::chrono::nanoseconds timeout) const;
  std::size_t count_graph_users() const {return 0;}

private:
  /// The endpoints of a kind in host.h.
  std::size_t count(
    std::int32_t kind, const std::string & name, detail::NameKind name_kind) const;
  EndpointInfos infos(std::int32_t kind, const std::string & topic, bool no_mangle) const;

  NodeBaseInterface::SharedPtr base_;
};

}  // namespace node_interfaces
}  // namespace rclcpp
