#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/qos.hpp"

namespace rclcpp
{

enum class QosPolicyKind
{
  AvoidRosNamespaceConventions, Deadline, Depth, Durability, History, Lifespan, Liveliness,
  LivelinessLeaseDuration, Reliability, Invalid
};

struct QosCallbackResult
{
  bool successful = false;
  std::string reason;
};

using QosCallback = std::function<QosCallbackResult (const QoS &)>;

/// Which policies parameters may change. Kept and not asked: the QoS stays as the program says.
class QosOverridingOptions
{
public:
  QosOverridingOptions() = default;
  QosOverridingOptions(
    std::initializer_list<QosPolicyKind> policy_kinds, QosCallback validation_callback = nullptr,
    std::string id = "")
  : policy_kinds_(policy_kinds), validation_callback_(std::move(validation_callback)),
    id_(std::move(id)) {}

  static QosOverridingOptions with_default_policies(
    QosCallback validation_callback = nullptr, std::string id = "")
  {
    return QosOverridingOptions(
      {QosPolicyKind::History, QosPolicyKind::Depth, QosPolicyKind::Reliability},
      std::move(validation_callback), std::move(id));
  }
  const std::string & get_id() const {return id_;}
  const std::vector<QosPolicyKind> & get_policy_kinds() const {return policy_kinds_;}
  const QosCallback & get_validation_callback() const {return validation_callback_;}

private:
  std::vector<QosPolicyKind> policy_kinds_;
  QosCallback validation_callback_;
  std::string id_;
};

}  // namespace rclcpp
