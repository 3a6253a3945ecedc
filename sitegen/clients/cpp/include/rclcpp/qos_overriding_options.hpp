#pragma once

#include <functional>
#include <initializer_list>
#include <memory>
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

const char * qos_policy_kind_to_cstr(const QosPolicyKind & kind);

struct QosCallbackResult
{
  bool successful = false;
  std::string reason;
};

using QosCallback = std::function<QosCallbackResult (const QoS &)>;

namespace node_interfaces
{
class NodeParametersInterface;
}  // namespace node_interfaces

class QosOverridingOptions;

namespace detail
{
QoS override_qos(
  const std::shared_ptr<node_interfaces::NodeParametersInterface> & parameters,
  const QosOverridingOptions & options, const std::string & topic, const char * endpoint,
  const QoS & qos);
}  // namespace detail

/// The policies that parameters may override.
class QosOverridingOptions
{
public:
  QosOverridingOptions() = default;
  QosOverridingOptions(
    std::initializer_list<QosPolicyKind> policy_kinds, QosCallback validation_callback = nullptr,
    std::string id = "")
  : policy_kinds_(policy_kinds), validation_callback_(std::move(validation_callback)),
    id_(std::move(id)), override_(&detail::override_qos) {}

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

  /// The function that declares the parameters; null, and not linked, without such policies.
  decltype(&detail::override_qos) override() const {return override_;}

private:
  std::vector<QosPolicyKind> policy_kinds_;
  QosCallback validation_callback_;
  std::string id_;
  decltype(&detail::override_qos) override_ = nullptr;
};

}  // namespace rclcpp
