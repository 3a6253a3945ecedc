// The node interfaces that templates use and that have no class of their own.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "rclcpp/client.hpp"
#include "rclcpp/clock.hpp"
#include "rclcpp/logger.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/timer.hpp"
#include "rclcpp/waitable.hpp"

namespace rclcpp
{
namespace node_interfaces
{

/// These only return the node: its entities are created from the node itself.
#define ROS_NODE_PART(Name, Members) \
  class Name \
  { \
public: \
    RCLCPP_SMART_PTR_ALIASES_ONLY(Name) \
    explicit Name(NodeBaseInterface::SharedPtr base) \
    : base_(std::move(base)) {} \
    NodeBaseInterface::SharedPtr get_node_base_interface() const {return base_;} \
    Members \
private: \
    NodeBaseInterface::SharedPtr base_; \
  };

#define ROS_RESOLVE(function, is_service) \
  std::string function(const std::string & name, bool only_expand = false) const \
  { \
    return base_->resolve_topic_or_service_name(name, is_service, only_expand); \
  }

#define ROS_WAITABLES \
  void add_waitable(Waitable::SharedPtr waitable, CallbackGroup::SharedPtr group) \
  { \
    base_->add(detail::ExecutableKind::kWaitable, waitable, group); \
  } \
  void remove_waitable(Waitable::SharedPtr waitable, CallbackGroup::SharedPtr group) noexcept \
  { \
    if (!group) {group = base_->get_default_callback_group();} \
    group->remove(detail::ExecutableKind::kWaitable, waitable); \
  }

#define ROS_TIMERS \
  void add_timer(TimerBase::SharedPtr timer, CallbackGroup::SharedPtr group) \
  { \
    base_->add(detail::ExecutableKind::kTimer, timer, group); \
  }

#define ROS_SERVICES \
  void add_client(std::shared_ptr<ClientBase> client, CallbackGroup::SharedPtr group) \
  { \
    base_->add(detail::ExecutableKind::kClient, client, group); \
  } \
  void add_service(std::shared_ptr<ServiceBase> service, CallbackGroup::SharedPtr group) \
  { \
    base_->add(detail::ExecutableKind::kService, service, group); \
  }

ROS_NODE_PART(NodeServicesInterface, ROS_RESOLVE(resolve_service_name, true) ROS_SERVICES)
ROS_NODE_PART(NodeTimersInterface, ROS_TIMERS)
ROS_NODE_PART(NodeTopicsInterface, ROS_RESOLVE(resolve_topic_name, false))
ROS_NODE_PART(NodeWaitablesInterface, ROS_WAITABLES)
ROS_NODE_PART(NodeTimeSourceInterface, )

#undef ROS_RESOLVE
#undef ROS_SERVICES
#undef ROS_TIMERS
#undef ROS_WAITABLES
#undef ROS_NODE_PART

class NodeClockInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeClockInterface)

  explicit NodeClockInterface(Clock::SharedPtr clock)
  : clock_(std::move(clock)) {}
  Clock::SharedPtr get_clock() {return clock_;}
  Clock::ConstSharedPtr get_clock() const {return clock_;}

private:
  Clock::SharedPtr clock_;
};

class NodeLoggingInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeLoggingInterface)

  explicit NodeLoggingInterface(Logger logger)
  : logger_(std::move(logger)) {}
  Logger get_logger() const {return logger_;}
  const char * get_logger_name() const {return logger_.get_name();}

private:
  Logger logger_;
};

}  // namespace node_interfaces
}  // namespace rclcpp
