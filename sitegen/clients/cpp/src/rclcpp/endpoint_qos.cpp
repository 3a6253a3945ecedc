#include "endpoint_qos.hpp"

#include <algorithm>
#include <limits>

namespace rclcpp
{
namespace detail
{

namespace
{

/// Convert to milliseconds.
double limit(const Duration & duration)
{
  const auto nanoseconds = duration.nanoseconds();
  if (nanoseconds == kInfinite) {
    return std::numeric_limits<double>::infinity();
  }
  return static_cast<double>(nanoseconds) / 1e6;
}

}  // namespace

QoS settled(std::int32_t kind, QoS qos)
{
  const bool much = kind != ROS_SUBSCRIPTION;
  const auto reliability = qos.reliability();
  if (reliability != ReliabilityPolicy::Reliable && reliability != ReliabilityPolicy::BestEffort) {
    qos.reliability(much ? ReliabilityPolicy::Reliable : ReliabilityPolicy::BestEffort);
  }
  const auto durability = qos.durability();
  if (durability != DurabilityPolicy::TransientLocal && durability != DurabilityPolicy::Volatile) {
    qos.durability(much ? DurabilityPolicy::TransientLocal : DurabilityPolicy::Volatile);
  }
  if (qos.history() != HistoryPolicy::KeepAll) {qos.history(HistoryPolicy::KeepLast);}
  if (qos.liveliness() != LivelinessPolicy::ManualByTopic) {
    qos.liveliness(LivelinessPolicy::Automatic);
  }
  rmw_qos_profile_t & profile = qos.get_rmw_qos_profile();
  for (rmw_time_t * time :
    {&profile.deadline, &profile.lifespan, &profile.liveliness_lease_duration})
  {
    if (time->sec == 0 && time->nsec == 0) {*time = RMW_DURATION_INFINITE;}
  }
  return qos;
}

ros_qos host_qos(const QoS & qos)
{
  const std::int32_t flags =
    (qos.reliability() == ReliabilityPolicy::Reliable ? ROS_RELIABLE : 0) |
    (qos.durability() == DurabilityPolicy::TransientLocal ? ROS_TRANSIENT_LOCAL : 0) |
    (qos.history() == HistoryPolicy::KeepAll ? ROS_KEEP_ALL : 0) |
    (qos.liveliness() == LivelinessPolicy::ManualByTopic ? ROS_MANUAL_BY_TOPIC : 0);
  return {
    limit(qos.deadline()), limit(qos.lifespan()), limit(qos.liveliness_lease_duration()),
    static_cast<std::int32_t>(std::max<std::size_t>(qos.depth(), 1)), flags};
}

}  // namespace detail
}  // namespace rclcpp
