#include "rclcpp/qos.hpp"

#include <tuple>
#include <utility>

#include "rclcpp/logging.hpp"

namespace rclcpp
{

namespace
{

auto as_tuple(const rmw_qos_profile_t & p)
{
  return std::make_tuple(
    p.history, p.depth, p.reliability, p.durability, p.deadline.sec, p.deadline.nsec,
    p.lifespan.sec, p.lifespan.nsec, p.liveliness, p.liveliness_lease_duration.sec,
    p.liveliness_lease_duration.nsec, p.avoid_ros_namespace_conventions);
}

/// An unspecified duration is infinite.
std::int64_t limit(const Duration & duration)
{
  return duration.nanoseconds() == 0 ? detail::kInfinite : duration.nanoseconds();
}

/// Policies that one side leaves to the system, so that compatibility is unknown.
std::string warnings(const rmw_qos_profile_t & offered, const rmw_qos_profile_t & requested)
{
  std::string found;
  const auto check = [&found](
    int theirs, int ours, int system, int weak, int strong, const char * both,
    const char * demanding, const char * modest) {
      const char * what = nullptr;
      if (theirs == system && ours == system) {what = both;}
      if (theirs == system && ours == strong) {what = demanding;}
      if (theirs == weak && ours == system) {what = modest;}
      if (what) {found += std::string("WARNING: ") + what + ";";}
    };
  check(
    offered.reliability, requested.reliability, RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT,
    RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT, RMW_QOS_POLICY_RELIABILITY_RELIABLE,
    "Publisher reliability is system_default and subscription reliability is system_default",
    "Reliable subscription, but publisher is system_default",
    "Best effort publisher, but subscription is system_default");
  check(
    offered.durability, requested.durability, RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT,
    RMW_QOS_POLICY_DURABILITY_VOLATILE, RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL,
    "Publisher durabilty is system_default and subscription durability is system_default",
    "Transient local subscription, but publisher is system_default",
    "Volatile publisher, but subscription is system_default");
  check(
    offered.liveliness, requested.liveliness, RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT,
    RMW_QOS_POLICY_LIVELINESS_AUTOMATIC, RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC,
    "Publisher liveliness is system_default and subscription liveliness is system_default",
    "Subscription's liveliness is manual by topic, but publisher's is system_default",
    "Publisher's liveliness is automatic, but subscription's is system_default");
  return found;
}

/// Warn once. Upstream, one of the two texts lacks the space.
void warn_of_zero_depth(bool & warned, const char * space)
{
  if (std::exchange(warned, true)) {return;}
  RCLCPP_WARN(
    Logger("rclcpp"),
    "A zero depth with KEEP_LAST doesn't make sense; no data could be stored.%s"
    "This will be interpreted as SYSTEM_DEFAULT", space);
}

}  // namespace

std::string qos_policy_name_from_kind(rmw_qos_policy_kind_t policy_kind)
{
  switch (policy_kind) {
    case RMW_QOS_POLICY_DURABILITY: return "DURABILITY_QOS_POLICY";
    case RMW_QOS_POLICY_DEADLINE: return "DEADLINE_QOS_POLICY";
    case RMW_QOS_POLICY_LIVELINESS: return "LIVELINESS_QOS_POLICY";
    case RMW_QOS_POLICY_RELIABILITY: return "RELIABILITY_QOS_POLICY";
    case RMW_QOS_POLICY_HISTORY: return "HISTORY_QOS_POLICY";
    case RMW_QOS_POLICY_LIFESPAN: return "LIFESPAN_QOS_POLICY";
    default: return "INVALID_QOS_POLICY";
  }
}

QoSInitialization::QoSInitialization(
  rmw_qos_history_policy_e history_policy, std::size_t history_depth, bool print_depth_warning)
: history_policy(history_policy), depth(history_depth)
{
  static bool warned = false;
  if (history_policy == RMW_QOS_POLICY_HISTORY_KEEP_LAST && !depth && print_depth_warning) {
    warn_of_zero_depth(warned, " ");
  }
}

QoSInitialization QoSInitialization::from_rmw(const rmw_qos_profile_t & rmw_qos)
{
  if (rmw_qos.history == RMW_QOS_POLICY_HISTORY_KEEP_ALL) {return KeepAll();}
  return KeepLast(rmw_qos.depth, rmw_qos.history != RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT);
}

QoS::QoS(const QoSInitialization & qos_initialization, const rmw_qos_profile_t & initial_profile)
: profile_(initial_profile)
{
  profile_.history = qos_initialization.history_policy;
  profile_.depth = qos_initialization.depth;
}

QoS & QoS::keep_last(std::size_t depth)
{
  static bool warned = false;
  if (!depth) {warn_of_zero_depth(warned, "");}
  profile_.depth = depth;
  return history(HistoryPolicy::KeepLast);
}

QoS & QoS::keep_all()
{
  profile_.depth = 0;
  return history(HistoryPolicy::KeepAll);
}

bool operator==(const QoS & left, const QoS & right)
{
  return as_tuple(left.get_rmw_qos_profile()) == as_tuple(right.get_rmw_qos_profile());
}

QoSCheckCompatibleResult qos_check_compatible(
  const QoS & publisher_qos, const QoS & subscription_qos)
{
  const QoS & offered = publisher_qos;
  const QoS & requested = subscription_qos;
  std::string reason;
  const auto check = [&reason](bool wrong, const char * what) {
      if (wrong) {reason += std::string("ERROR: ") + what + ";";}
    };
  check(
    offered.reliability() == ReliabilityPolicy::BestEffort &&
    requested.reliability() == ReliabilityPolicy::Reliable,
    "Best effort publisher and reliable subscription");
  check(
    offered.durability() == DurabilityPolicy::Volatile &&
    requested.durability() == DurabilityPolicy::TransientLocal,
    "Volatile publisher and transient local subscription");
  const auto deadlines = std::make_pair(limit(offered.deadline()), limit(requested.deadline()));
  check(
    deadlines.first == detail::kInfinite && deadlines.second != detail::kInfinite,
    "Subscription has a deadline, but publisher does not");
  check(
    deadlines.first != detail::kInfinite && deadlines.second < deadlines.first,
    "Subscription deadline is less than publisher deadline");
  check(
    offered.liveliness() == LivelinessPolicy::Automatic &&
    requested.liveliness() == LivelinessPolicy::ManualByTopic,
    "Publisher's liveliness is automatic and subscription's is manual by topic");
  const auto leases = std::make_pair(
    limit(offered.liveliness_lease_duration()), limit(requested.liveliness_lease_duration()));
  check(
    leases.first == detail::kInfinite && leases.second != detail::kInfinite,
    "Subscription has a liveliness lease duration, but publisher does not");
  check(
    leases.first != detail::kInfinite && leases.second < leases.first,
    "Subscription liveliness lease duration is less than publisher");
  if (!reason.empty()) {return {QoSCompatibility::Error, reason};}
  reason = warnings(offered.get_rmw_qos_profile(), requested.get_rmw_qos_profile());
  return {reason.empty() ? QoSCompatibility::Ok : QoSCompatibility::Warning, reason};
}

}  // namespace rclcpp
