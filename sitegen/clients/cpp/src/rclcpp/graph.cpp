// Graph queries.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "rclcpp/detail/host.h"
#include "rclcpp/detail/names.hpp"
#include "rclcpp/detail/platform.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/node_interfaces/node_graph_interface.hpp"

namespace rclcpp
{
namespace node_interfaces
{

namespace
{

using NamesAndTypes = NodeGraphInterface::NamesAndTypes;

/// A node or one of its endpoints.
struct Entry
{
  ros_entry is;
  std::string node;
  std::string name;
  std::string type;
};

/// The entries of the graph of these kinds.
std::vector<Entry> look(std::initializer_list<std::int32_t> kinds)
{
  std::int32_t size;
  while ((size = ros_look()) < 0) {detail::wait(-1);}
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
  ros_read(bytes.data());
  std::vector<Entry> found;
  for (const std::uint8_t * at = bytes.data(), * end = at + size; at < end;) {
    Entry entry;
    std::memcpy(&entry.is, at, sizeof(entry.is));
    const char * text = reinterpret_cast<const char *>(at) + sizeof(entry.is);
    for (std::string * to : {&entry.node, &entry.name, &entry.type}) {
      *to = text;
      text += to->size() + 1;
    }
    at += entry.is.size;
    if (std::find(kinds.begin(), kinds.end(), entry.is.kind) != kinds.end()) {
      found.push_back(std::move(entry));
    }
  }
  return found;
}

/// The name and namespace of a node.
std::pair<std::string, std::string> split(const std::string & node)
{
  const auto slash = node.rfind('/');
  return {node.substr(slash + 1), slash == 0 ? "/" : node.substr(0, slash)};
}

void add(NamesAndTypes & found, const std::string & name, const std::string & type)
{
  auto & types = found[name];
  const auto place = std::lower_bound(types.begin(), types.end(), type);
  if (place == types.end() || *place != type) {types.insert(place, type);}
}

/// Add the DDS topic name and type of an endpoint, or of a part of it.
void add_dds(
  NamesAndTypes & found, const Entry & entry, const char * prefix, const char * suffix,
  const char * part)
{
  const auto package = entry.type.find('/');
  const auto name = entry.type.rfind('/');
  add(
    found, prefix + entry.name + suffix,
    entry.type.substr(0, package) + "::" + entry.type.substr(package + 1, name - package - 1) +
    "::dds_::" + entry.type.substr(name + 1) + part + "_");
}

NamesAndTypes names_and_types(const std::vector<Entry> & entries, bool no_demangle = false)
{
  NamesAndTypes found;
  for (const auto & entry : entries) {
    const bool topic = entry.is.kind == ROS_PUBLISHER || entry.is.kind == ROS_SUBSCRIPTION;
    if (!no_demangle) {
      add(found, entry.name, entry.type);
    } else if (topic) {
      add_dds(found, entry, "rt", "", "");
    } else {
      add_dds(found, entry, "rq", "Request", "_Request");
      add_dds(found, entry, "rr", "Reply", "_Response");
    }
  }
  return found;
}

/// The endpoints of one kind of a node; throws RCLError if there is no such node.
std::vector<Entry> of_node(
  std::int32_t kind, const char * what, const std::string & name, const std::string & name_space)
{
  auto found = look({ROS_NODE, kind});
  const auto is_other = [&](const Entry & entry) {
      return split(entry.node) != std::make_pair(name, name_space);
    };
  found.erase(std::remove_if(found.begin(), found.end(), is_other), found.end());
  if (found.empty()) {
    throw exceptions::RCLError(
            std::string("failed to get ") + what + " names and types by node: cannot get " + what +
            " names and types for nonexistent node");
  }
  const auto is_node = [](const Entry & entry) {return entry.is.kind == ROS_NODE;};
  found.erase(std::remove_if(found.begin(), found.end(), is_node), found.end());
  return found;
}

Duration duration(double milliseconds)
{
  return Duration::from_nanoseconds(
    std::isinf(milliseconds) ? detail::kInfinite : std::llround(milliseconds * 1e6));
}

TopicEndpointInfo info(const Entry & entry)
{
  const auto & from = entry.is.qos;
  const auto [name, name_space] = split(entry.node);
  rmw_qos_profile_t unknown{};
  unknown.history = RMW_QOS_POLICY_HISTORY_UNKNOWN;
  QoS qos(QoSInitialization(RMW_QOS_POLICY_HISTORY_UNKNOWN, 0), unknown);
  qos.reliability(
    from.flags & ROS_RELIABLE ? ReliabilityPolicy::Reliable : ReliabilityPolicy::BestEffort)
  .durability(
    from.flags & ROS_TRANSIENT_LOCAL ?
    DurabilityPolicy::TransientLocal : DurabilityPolicy::Volatile)
  .liveliness(
    from.flags & ROS_MANUAL_BY_TOPIC ?
    LivelinessPolicy::ManualByTopic : LivelinessPolicy::Automatic)
  .deadline(duration(from.deadline)).lifespan(duration(from.lifespan))
  .liveliness_lease_duration(duration(from.lease));
  // In the same form as a message's publisher_gid.
  TopicEndpointInfo::Gid gid{};
  std::memcpy(gid.data(), &entry.is.gid, sizeof(entry.is.gid));
  const auto kind =
    entry.is.kind == ROS_PUBLISHER ? EndpointType::Publisher : EndpointType::Subscription;
  return TopicEndpointInfo(name, name_space, entry.type, kind, gid, qos);
}

class GraphEvent : public Event
{
public:
  bool check() override {return Event::check() || ros_changes() != seen_;}
  bool check_and_clear() override
  {
    const bool changed = ros_changes() != seen_;
    seen_ = ros_changes();
    return Event::check_and_clear() || changed;
  }

private:
  std::uint32_t seen_ = ros_changes();
};

}  // namespace

NamesAndTypes NodeGraphInterface::get_topic_names_and_types(bool no_demangle) const
{
  if (!no_demangle) {return names_and_types(look({ROS_PUBLISHER, ROS_SUBSCRIPTION}));}
  return names_and_types(look({ROS_PUBLISHER, ROS_SUBSCRIPTION, ROS_SERVICE, ROS_CLIENT}), true);
}

NamesAndTypes NodeGraphInterface::get_service_names_and_types() const
{
  return names_and_types(look({ROS_SERVICE, ROS_CLIENT}));
}

NamesAndTypes NodeGraphInterface::get_service_names_and_types_by_node(
  const std::string & node_name, const std::string & node_namespace) const
{
  return names_and_types(of_node(ROS_SERVICE, "service", node_name, node_namespace));
}

NamesAndTypes NodeGraphInterface::get_client_names_and_types_by_node(
  const std::string & node_name, const std::string & node_namespace) const
{
  return names_and_types(of_node(ROS_CLIENT, "client", node_name, node_namespace));
}

NamesAndTypes NodeGraphInterface::get_publisher_names_and_types_by_node(
  const std::string & node_name, const std::string & node_namespace, bool no_demangle) const
{
  return names_and_types(
    of_node(ROS_PUBLISHER, "publisher", node_name, node_namespace), no_demangle);
}

NamesAndTypes NodeGraphInterface::get_subscriber_names_and_types_by_node(
  const std::string & node_name, const std::string & node_namespace, bool no_demangle) const
{
  return names_and_types(
    of_node(ROS_SUBSCRIPTION, "subscriber", node_name, node_namespace), no_demangle);
}

std::vector<std::string> NodeGraphInterface::get_node_names() const
{
  std::vector<std::string> names;
  for (const auto & entry : look({ROS_NODE})) {names.push_back(entry.node);}
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::pair<std::string, std::string>>
NodeGraphInterface::get_node_names_and_namespaces() const
{
  std::vector<std::pair<std::string, std::string>> names;
  for (const auto & node : get_node_names()) {names.push_back(split(node));}
  return names;
}

std::vector<std::tuple<std::string, std::string, std::string>>
NodeGraphInterface::get_node_names_with_enclaves() const
{
  std::vector<std::tuple<std::string, std::string, std::string>> names;
  for (const auto & [name, name_space] : get_node_names_and_namespaces()) {
    names.emplace_back(name, name_space, "/");
  }
  return names;
}

std::size_t NodeGraphInterface::count_publishers(const std::string & topic_name) const
{
  return count(ROS_PUBLISHER, topic_name, detail::NameKind::Topic);
}

std::size_t NodeGraphInterface::count_subscribers(const std::string & topic_name) const
{
  return count(ROS_SUBSCRIPTION, topic_name, detail::NameKind::Topic);
}

std::size_t NodeGraphInterface::count_clients(const std::string & service_name) const
{
  return count(ROS_CLIENT, service_name, detail::NameKind::Service);
}

std::size_t NodeGraphInterface::count_services(const std::string & service_name) const
{
  return count(ROS_SERVICE, service_name, detail::NameKind::Service);
}

std::size_t NodeGraphInterface::count(
  std::int32_t kind, const std::string & name, detail::NameKind name_kind) const
{
  // As upstream: expanded, not remapped.
  const std::string full =
    detail::expand_name(base_->get_name(), base_->get_namespace(), name, name_kind);
  const auto all = look({kind});
  return static_cast<std::size_t>(
    std::count_if(
      all.begin(), all.end(), [&full](const Entry & entry) {return entry.name == full;}));
}

std::vector<TopicEndpointInfo> NodeGraphInterface::get_publishers_info_by_topic(
  const std::string & topic_name, bool no_mangle) const
{
  return infos(ROS_PUBLISHER, topic_name, no_mangle);
}

std::vector<TopicEndpointInfo> NodeGraphInterface::get_subscriptions_info_by_topic(
  const std::string & topic_name, bool no_mangle) const
{
  return infos(ROS_SUBSCRIPTION, topic_name, no_mangle);
}

std::vector<TopicEndpointInfo> NodeGraphInterface::infos(
  std::int32_t kind, const std::string & topic, bool no_mangle) const
{
  if (no_mangle && topic.rfind("rt/", 0) != 0) {return {};}
  const std::string full =
    no_mangle ? topic.substr(2) : base_->resolve(topic, detail::NameKind::Topic);
  std::vector<TopicEndpointInfo> found;
  for (const auto & entry : look({kind})) {
    if (entry.name == full) {found.push_back(info(entry));}
  }
  return found;
}

Event::SharedPtr NodeGraphInterface::get_graph_event() const
{
  return std::make_shared<GraphEvent>();
}

void NodeGraphInterface::wait_for_graph_change(
  Event::SharedPtr event, std::chrono::nanoseconds timeout) const
{
  if (!event) {throw exceptions::InvalidEventError();}
  const double limit = std::chrono::duration<double, std::milli>(timeout).count();
  const double end = detail::now() + limit;
  while (!event->check() && base_->get_context()->is_valid()) {
    const double left = end - detail::now();
    if (limit >= 0 && left <= 0) {return;}
    detail::wait(limit < 0 ? -1 : left);
  }
}

}  // namespace node_interfaces
}  // namespace rclcpp
