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

/// Something that is ready; one of the first five is set. While it is there, nothing else of its callback
/// group runs, if that is mutually exclusive.
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
  /// What a timer or a waitable calls back with.
  std::shared_ptr<void> data;
};

}  // namespace rclcpp
