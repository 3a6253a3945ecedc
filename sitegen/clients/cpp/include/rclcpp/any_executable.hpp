#pragma once

#include <memory>

#include "rclcpp/callback_group.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{

class ClientBase;
class ServiceBase;
class SubscriptionBase;
class TimerBase;
class Waitable;

namespace node_interfaces {class NodeBaseInterface;}

/// A ready entity; one of the first five members is set. While it exists, no other callback of its group
/// runs if the group is mutually exclusive.
struct AnyExecutable
{
  AnyExecutable() = default;
  RCLCPP_DISABLE_COPY(AnyExecutable)
  virtual ~AnyExecutable() {if (callback_group) {callback_group->give_back();}}

  std::shared_ptr<SubscriptionBase> subscription;
  std::shared_ptr<TimerBase> timer;
  std::shared_ptr<ServiceBase> service;
  std::shared_ptr<ClientBase> client;
  std::shared_ptr<Waitable> waitable;
  CallbackGroup::SharedPtr callback_group;
  std::shared_ptr<node_interfaces::NodeBaseInterface> node_base;
  /// The data for the callback of a timer or a waitable.
  std::shared_ptr<void> data;
};

}  // namespace rclcpp
