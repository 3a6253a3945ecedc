// Parameters that override the QoS of a publisher or a subscription.
#include <cstdint>
#include <string>
#include <utility>

#include "rclcpp/exceptions.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/qos_overriding_options.hpp"

namespace rclcpp
{

const char * qos_policy_kind_to_cstr(const QosPolicyKind & kind)
{
  switch (kind) {
    case QosPolicyKind::AvoidRosNamespaceConventions: return "avoid_ros_namespace_conventions";
    case QosPolicyKind::Deadline: return "deadline";
    case QosPolicyKind::Depth: return "depth";
    case QosPolicyKind::Durability: return "durability";
    case QosPolicyKind::History: return "history";
    case QosPolicyKind::Lifespan: return "lifespan";
    case QosPolicyKind::Liveliness: return "liveliness";
    case QosPolicyKind::LivelinessLeaseDuration: return "liveliness_lease_duration";
    case QosPolicyKind::Reliability: return "reliability";
    default: throw std::invalid_argument("unknown QoS policy kind");
  }
}

namespace detail
{

namespace
{

template<class PolicyT>
using Names = std::pair<PolicyT, const char *>;

const Names<HistoryPolicy> kHistories[] = {
  {HistoryPolicy::SystemDefault, "system_default"}, {HistoryPolicy::KeepLast, "keep_last"},
  {HistoryPolicy::KeepAll, "keep_all"}};
const Names<ReliabilityPolicy> kReliabilities[] = {
  {ReliabilityPolicy::SystemDefault, "system_default"},
  {ReliabilityPolicy::Reliable, "reliable"}, {ReliabilityPolicy::BestEffort, "best_effort"},
  {ReliabilityPolicy::BestAvailable, "best_available"}};
const Names<DurabilityPolicy> kDurabilities[] = {
  {DurabilityPolicy::SystemDefault, "system_default"},
  {DurabilityPolicy::TransientLocal, "transient_local"},
  {DurabilityPolicy::Volatile, "volatile"}, {DurabilityPolicy::BestAvailable, "best_available"}};
const Names<LivelinessPolicy> kLivelinesses[] = {
  {LivelinessPolicy::SystemDefault, "system_default"},
  {LivelinessPolicy::Automatic, "automatic"},
  {LivelinessPolicy::ManualByTopic, "manual_by_topic"},
  {LivelinessPolicy::BestAvailable, "best_available"}};

/// Declares the QoS parameters of one endpoint.
class Overrides
{
public:
  Overrides(
    node_interfaces::NodeParametersInterface & parameters, std::string prefix,
    const std::string & what)
  : parameters_(parameters), prefix_(std::move(prefix)), what_(what) {}

  template<class T>
  T declare(QosPolicyKind kind, const T & value)
  {
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.description = std::string("qos policy {") + qos_policy_kind_to_cstr(kind) + "} for " +
      what_;
    descriptor.read_only = true;
    return parameters_.declare_parameter(
      prefix_ + qos_policy_kind_to_cstr(kind), ParameterValue(value), descriptor).get<T>();
  }

  Duration time(QosPolicyKind kind, const Duration & value)
  {
    return Duration::from_nanoseconds(declare<std::int64_t>(kind, value.nanoseconds()));
  }

  template<class PolicyT, std::size_t N>
  PolicyT policy(QosPolicyKind kind, PolicyT value, const Names<PolicyT> (& names)[N])
  {
    std::string now = "unknown";
    for (const auto & [known, name] : names) {
      if (known == value) {now = name;}
    }
    const auto wanted = declare(kind, now);
    for (const auto & [known, name] : names) {
      if (wanted == name) {return known;}
    }
    throw exceptions::InvalidQosOverridesException(
            std::string("Unknown QoS ") + qos_policy_kind_to_cstr(kind) + " policy '" + wanted +
            "' for " + what_);
  }

private:
  node_interfaces::NodeParametersInterface & parameters_;
  std::string prefix_;
  std::string what_;
};

void override_one(QosPolicyKind kind, Overrides & overrides, QoS & qos)
{
  switch (kind) {
    case QosPolicyKind::AvoidRosNamespaceConventions:
      qos.avoid_ros_namespace_conventions(
        overrides.declare(kind, qos.avoid_ros_namespace_conventions()));
      break;
    case QosPolicyKind::Deadline: qos.deadline(overrides.time(kind, qos.deadline())); break;
    case QosPolicyKind::Depth:
      qos.get_rmw_qos_profile().depth = static_cast<std::size_t>(
        overrides.declare(kind, static_cast<std::int64_t>(qos.depth())));
      break;
    case QosPolicyKind::Durability:
      qos.durability(overrides.policy(kind, qos.durability(), kDurabilities));
      break;
    case QosPolicyKind::History:
      qos.history(overrides.policy(kind, qos.history(), kHistories));
      break;
    case QosPolicyKind::Lifespan: qos.lifespan(overrides.time(kind, qos.lifespan())); break;
    case QosPolicyKind::Liveliness:
      qos.liveliness(overrides.policy(kind, qos.liveliness(), kLivelinesses));
      break;
    case QosPolicyKind::LivelinessLeaseDuration:
      qos.liveliness_lease_duration(overrides.time(kind, qos.liveliness_lease_duration()));
      break;
    case QosPolicyKind::Reliability:
      qos.reliability(overrides.policy(kind, qos.reliability(), kReliabilities));
      break;
    default: throw std::invalid_argument("unknown QoS policy kind");
  }
}

}  // namespace

QoS override_qos(
  const node_interfaces::NodeParametersInterface::SharedPtr & parameters,
  const QosOverridingOptions & options, const std::string & topic, const char * endpoint,
  const QoS & qos)
{
  const std::string suffix = options.get_id().empty() ? "" : "_" + options.get_id();
  Overrides overrides(
    *parameters, "qos_overrides." + topic + "." + endpoint + suffix + ".",
    std::string(endpoint) + " {" + topic + "}" +
    (options.get_id().empty() ? "" : " with id {" + options.get_id() + "}"));
  QoS changed = qos;
  for (const auto kind : options.get_policy_kinds()) {override_one(kind, overrides, changed);}
  if (options.get_validation_callback()) {
    const auto result = options.get_validation_callback()(changed);
    if (!result.successful) {
      throw exceptions::InvalidQosOverridesException("validation callback failed: " + result.reason);
    }
  }
  return changed;
}

}  // namespace detail
}  // namespace rclcpp
