#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "rclcpp/client.hpp"
#include "rclcpp/clock.hpp"
#include "rclcpp/detail/rosout.hpp"
#include "rclcpp/logger.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_options.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp/timer.hpp"

namespace rclcpp
{

class Node : public std::enable_shared_from_this<Node>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Node)
  RCLCPP_DISABLE_COPY(Node)

  explicit Node(const std::string & name, const NodeOptions & options = NodeOptions());
  Node(
    const std::string & name, const std::string & name_space,
    const NodeOptions & options = NodeOptions());
  virtual ~Node() = default;

  const char * get_name() const {return base_->get_name();}
  const char * get_namespace() const {return base_->get_namespace();}
  const char * get_fully_qualified_name() const {return base_->get_fully_qualified_name();}
  Logger get_logger() const {return logger_;}
  Clock::SharedPtr get_clock() {return clock_;}
  Clock::ConstSharedPtr get_clock() const {return clock_;}
  Time now() const {return clock_->now();}
  node_interfaces::NodeBaseInterface::SharedPtr get_node_base_interface() {return base_;}

  CallbackGroup::SharedPtr create_callback_group(
    CallbackGroupType group_type, bool automatically_add_to_executor_with_node = true)
  {
    return base_->create_callback_group(group_type, automatically_add_to_executor_with_node);
  }
  void for_each_callback_group(
    const node_interfaces::NodeBaseInterface::CallbackGroupFunction & function)
  {
    base_->for_each_callback_group(function);
  }
  const NodeOptions & get_node_options() const {return options_;}

  template<class MessageT, class AllocatorT = std::allocator<void>>
  std::shared_ptr<Publisher<MessageT, AllocatorT>> create_publisher(
    const std::string & topic, const QoS & qos,
    const PublisherOptions & options = PublisherOptions())
  {
    auto publisher = std::make_shared<Publisher<MessageT, AllocatorT>>(
      *base_, topic, qos, options);
    base_->add(
      detail::ExecutableKind::kWaitable, publisher->events(), options.callback_group);
    return publisher;
  }

  template<class MessageT, class CallbackT>
  std::shared_ptr<Subscription<MessageT>> create_subscription(
    const std::string & topic, const QoS & qos, CallbackT && callback,
    const SubscriptionOptions & options = SubscriptionOptions())
  {
    auto subscription = std::make_shared<Subscription<MessageT>>(
      *base_, topic, qos, std::forward<CallbackT>(callback), options);
    base_->add(detail::ExecutableKind::kSubscription, subscription, options.callback_group);
    base_->add(
      detail::ExecutableKind::kWaitable, subscription->events(), options.callback_group);
    return subscription;
  }

  template<class ServiceT, class CallbackT>
  std::shared_ptr<Service<ServiceT>> create_service(
    const std::string & name, CallbackT && callback, const QoS & qos = ServicesQoS(),
    CallbackGroup::SharedPtr group = nullptr)
  {
    auto service = std::make_shared<Service<ServiceT>>(
      *base_, name, qos, std::forward<CallbackT>(callback));
    base_->add(detail::ExecutableKind::kService, service, group);
    return service;
  }

  template<class ServiceT>
  std::shared_ptr<Client<ServiceT>> create_client(
    const std::string & name, const QoS & qos = ServicesQoS(),
    CallbackGroup::SharedPtr group = nullptr)
  {
    auto client = std::make_shared<Client<ServiceT>>(*base_, name, qos);
    base_->add(detail::ExecutableKind::kClient, client, group);
    return client;
  }

  template<class Rep, class Period, class CallbackT>
  typename WallTimer<CallbackT>::SharedPtr create_wall_timer(
    std::chrono::duration<Rep, Period> period, CallbackT callback,
    CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
  {
    auto timer = std::make_shared<WallTimer<CallbackT>>(
      detail::timer_period(period), detail::timer_callback(std::move(callback)), autostart);
    base_->add(detail::ExecutableKind::kTimer, timer, group);
    return timer;
  }

  /// A timer on the node's clock, which may be that of /clock.
  template<class Rep, class Period, class CallbackT>
  typename GenericTimer<CallbackT>::SharedPtr create_timer(
    std::chrono::duration<Rep, Period> period, CallbackT callback,
    CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
  {
    auto timer = std::make_shared<GenericTimer<CallbackT>>(
      clock_, detail::timer_period(period), detail::timer_callback(std::move(callback)), autostart);
    base_->add(detail::ExecutableKind::kTimer, timer, group);
    return timer;
  }

private:
  NodeOptions options_;
  node_interfaces::NodeBaseInterface::SharedPtr base_;
  Logger logger_;
  detail::Rosout rosout_;
  Clock::SharedPtr clock_;
};

}  // namespace rclcpp
