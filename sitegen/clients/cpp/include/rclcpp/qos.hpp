// Quality of service: the policies that a publisher offers and a subscription requests.
#pragma once

#include <cstddef>
#include <string>

#include "rclcpp/duration.hpp"
#include "rmw/qos_profiles.h"
#include "rmw/types.h"

namespace rclcpp
{

enum class HistoryPolicy
{
  KeepLast = RMW_QOS_POLICY_HISTORY_KEEP_LAST,
  KeepAll = RMW_QOS_POLICY_HISTORY_KEEP_ALL,
  SystemDefault = RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT,
  Unknown = RMW_QOS_POLICY_HISTORY_UNKNOWN,
};

enum class ReliabilityPolicy
{
  BestEffort = RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT,
  Reliable = RMW_QOS_POLICY_RELIABILITY_RELIABLE,
  SystemDefault = RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT,
  BestAvailable = RMW_QOS_POLICY_RELIABILITY_BEST_AVAILABLE,
  Unknown = RMW_QOS_POLICY_RELIABILITY_UNKNOWN,
};

enum class DurabilityPolicy
{
  Volatile = RMW_QOS_POLICY_DURABILITY_VOLATILE,
  TransientLocal = RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL,
  SystemDefault = RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT,
  BestAvailable = RMW_QOS_POLICY_DURABILITY_BEST_AVAILABLE,
  Unknown = RMW_QOS_POLICY_DURABILITY_UNKNOWN,
};

enum class LivelinessPolicy
{
  Automatic = RMW_QOS_POLICY_LIVELINESS_AUTOMATIC,
  ManualByTopic = RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC,
  SystemDefault = RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT,
  BestAvailable = RMW_QOS_POLICY_LIVELINESS_BEST_AVAILABLE,
  Unknown = RMW_QOS_POLICY_LIVELINESS_UNKNOWN,
};

enum class QoSCompatibility {Ok, Warning, Error};

/// "RELIABILITY_QOS_POLICY" and so on.
std::string qos_policy_name_from_kind(rmw_qos_policy_kind_t policy_kind);

struct QoSInitialization
{
  QoSInitialization(
    rmw_qos_history_policy_e history_policy, std::size_t history_depth,
    bool print_depth_warning = true);

  static QoSInitialization from_rmw(const rmw_qos_profile_t & rmw_qos);

  rmw_qos_history_policy_e history_policy;
  std::size_t depth;
};

struct KeepLast : QoSInitialization
{
  explicit KeepLast(std::size_t depth, bool print_depth_warning = true)
  : QoSInitialization(RMW_QOS_POLICY_HISTORY_KEEP_LAST, depth, print_depth_warning) {}
};

struct KeepAll : QoSInitialization
{
  KeepAll()
  : QoSInitialization(RMW_QOS_POLICY_HISTORY_KEEP_ALL, 0) {}
};

class QoS
{
public:
  explicit QoS(
    const QoSInitialization & qos_initialization,
    const rmw_qos_profile_t & initial_profile = rmw_qos_profile_default);
  QoS(std::size_t history_depth)  // NOLINT: implicit upstream
  : QoS(KeepLast(history_depth)) {}

  rmw_qos_profile_t & get_rmw_qos_profile() {return profile_;}
  const rmw_qos_profile_t & get_rmw_qos_profile() const {return profile_;}

  HistoryPolicy history() const {return HistoryPolicy(profile_.history);}
  std::size_t depth() const {return profile_.depth;}
  ReliabilityPolicy reliability() const {return ReliabilityPolicy(profile_.reliability);}
  DurabilityPolicy durability() const {return DurabilityPolicy(profile_.durability);}
  Duration deadline() const {return Duration::from_rmw_time(profile_.deadline);}
  Duration lifespan() const {return Duration::from_rmw_time(profile_.lifespan);}
  LivelinessPolicy liveliness() const {return LivelinessPolicy(profile_.liveliness);}
  Duration liveliness_lease_duration() const
  {
    return Duration::from_rmw_time(profile_.liveliness_lease_duration);
  }
  bool avoid_ros_namespace_conventions() const
  {
    return profile_.avoid_ros_namespace_conventions;
  }

  QoS & history(HistoryPolicy policy) {return history(rmw_qos_history_policy_e(policy));}
  QoS & history(rmw_qos_history_policy_e policy) {profile_.history = policy; return *this;}
  QoS & keep_last(std::size_t depth);
  QoS & keep_all();
  QoS & reliability(ReliabilityPolicy policy)
  {
    return reliability(rmw_qos_reliability_policy_e(policy));
  }
  QoS & reliability(rmw_qos_reliability_policy_e policy)
  {
    profile_.reliability = policy;
    return *this;
  }
  QoS & reliable() {return reliability(ReliabilityPolicy::Reliable);}
  QoS & best_effort() {return reliability(ReliabilityPolicy::BestEffort);}
  QoS & reliability_best_available() {return reliability(ReliabilityPolicy::BestAvailable);}
  QoS & durability(DurabilityPolicy policy)
  {
    return durability(rmw_qos_durability_policy_e(policy));
  }
  QoS & durability(rmw_qos_durability_policy_e policy)
  {
    profile_.durability = policy;
    return *this;
  }
  QoS & durability_volatile() {return durability(DurabilityPolicy::Volatile);}
  QoS & transient_local() {return durability(DurabilityPolicy::TransientLocal);}
  QoS & durability_best_available() {return durability(DurabilityPolicy::BestAvailable);}
  QoS & deadline(rmw_time_t deadline) {profile_.deadline = deadline; return *this;}
  QoS & deadline(const Duration & duration) {return deadline(duration.to_rmw_time());}
  QoS & lifespan(rmw_time_t lifespan) {profile_.lifespan = lifespan; return *this;}
  QoS & lifespan(const Duration & duration) {return lifespan(duration.to_rmw_time());}
  QoS & liveliness(LivelinessPolicy policy)
  {
    return liveliness(rmw_qos_liveliness_policy_e(policy));
  }
  QoS & liveliness(rmw_qos_liveliness_policy_e policy)
  {
    profile_.liveliness = policy;
    return *this;
  }
  QoS & liveliness_lease_duration(rmw_time_t lease)
  {
    profile_.liveliness_lease_duration = lease;
    return *this;
  }
  QoS & liveliness_lease_duration(const Duration & lease)
  {
    return liveliness_lease_duration(lease.to_rmw_time());
  }
  QoS & avoid_ros_namespace_conventions(bool avoid)
  {
    profile_.avoid_ros_namespace_conventions = avoid;
    return *this;
  }

private:
  rmw_qos_profile_t profile_;
};

bool operator==(const QoS & left, const QoS & right);
inline bool operator!=(const QoS & left, const QoS & right) {return !(left == right);}

struct QoSCheckCompatibleResult
{
  QoSCompatibility compatibility;
  std::string reason;
};

/// Whether a publisher and a subscription with these profiles are compatible, and the reason if not.
QoSCheckCompatibleResult qos_check_compatible(
  const QoS & publisher_qos, const QoS & subscription_qos);

/// A profile with a name, and a history of one's own if wanted.
#define ROS_NAMED_QOS(Name, profile) \
  class Name : public QoS \
  { \
public: \
    explicit Name( \
      const QoSInitialization & qos_initialization = QoSInitialization::from_rmw(profile)) \
    : QoS(qos_initialization, profile) {} \
  };

ROS_NAMED_QOS(SensorDataQoS, rmw_qos_profile_sensor_data)
ROS_NAMED_QOS(ParametersQoS, rmw_qos_profile_parameters)
ROS_NAMED_QOS(ServicesQoS, rmw_qos_profile_services_default)
ROS_NAMED_QOS(ParameterEventsQoS, rmw_qos_profile_parameter_events)
ROS_NAMED_QOS(RosoutQoS, rmw_qos_profile_rosout_default)
ROS_NAMED_QOS(SystemDefaultsQoS, rmw_qos_profile_system_default)
ROS_NAMED_QOS(BestAvailableQoS, rmw_qos_profile_best_available)

#undef ROS_NAMED_QOS

class ClockQoS : public QoS
{
public:
  explicit ClockQoS(const QoSInitialization & qos_initialization = KeepLast(1))
  : QoS(qos_initialization) {best_effort();}
};

}  // namespace rclcpp
