#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "rclcpp/client.hpp"
#include "rclcpp/clock.hpp"
#include "rclcpp/detail/has_parameters.hpp"
#include "rclcpp/detail/rosout.hpp"
#include "rclcpp/detail/sees_graph.hpp"
#include "rclcpp/generic_client.hpp"
#include "rclcpp/generic_publisher.hpp"
#include "rclcpp/generic_service.hpp"
#include "rclcpp/generic_subscription.hpp"
#include "rclcpp/logger.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/message_memory_strategy.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_parts.hpp"
#include "rclcpp/node_options.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/rate.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp/time_source.hpp"
#include "rclcpp/timer.hpp"
#include "rclcpp/utilities.hpp"

namespace rclcpp
{
namespace detail
{

/// What nodes and lifecycle nodes have in common. As upstream, neither is one of the other kind, so
/// that functions can be overloaded for both.
class AnyNode : public SeesGraph, public HasParameters
{
public:
  RCLCPP_DISABLE_COPY(AnyNode)

  virtual ~AnyNode() = default;

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

  const std::string & get_sub_namespace() const {return sub_namespace_;}
  std::string get_effective_namespace() const;

  node_interfaces::NodeClockInterface::SharedPtr get_node_clock_interface()
  {
    return std::make_shared<node_interfaces::NodeClockInterface>(clock_);
  }
  node_interfaces::NodeLoggingInterface::SharedPtr get_node_logging_interface()
  {
    return std::make_shared<node_interfaces::NodeLoggingInterface>(logger_);
  }
  node_interfaces::NodeServicesInterface::SharedPtr get_node_services_interface()
  {
    return std::make_shared<node_interfaces::NodeServicesInterface>(base_);
  }
  node_interfaces::NodeTimersInterface::SharedPtr get_node_timers_interface()
  {
    return std::make_shared<node_interfaces::NodeTimersInterface>(base_);
  }
  node_interfaces::NodeTopicsInterface::SharedPtr get_node_topics_interface()
  {
    return std::make_shared<node_interfaces::NodeTopicsInterface>(base_);
  }
  node_interfaces::NodeWaitablesInterface::SharedPtr get_node_waitables_interface()
  {
    return std::make_shared<node_interfaces::NodeWaitablesInterface>(base_);
  }
  node_interfaces::NodeTimeSourceInterface::SharedPtr get_node_time_source_interface()
  {
    return std::make_shared<node_interfaces::NodeTimeSourceInterface>(base_);
  }

  template<class MessageT, class AllocatorT = std::allocator<void>>
  std::shared_ptr<Publisher<MessageT, AllocatorT>> create_publisher(
    const std::string & topic, const QoS & qos,
    const PublisherOptionsWithAllocator<AllocatorT> & options =
    PublisherOptionsWithAllocator<AllocatorT>())
  {
    auto publisher = std::make_shared<Publisher<MessageT, AllocatorT>>(
      *base_, extend_name(topic), with_overrides(qos, options, topic, "publisher"), options);
    publisher->set_node_default(options_.use_intra_process_comms());
    base_->add(
      ExecutableKind::kWaitable, publisher->events(), options.callback_group);
    return publisher;
  }

  template<
    class MessageT, class CallbackT, class AllocatorT = std::allocator<void>,
    class MemoryStrategyT =
    message_memory_strategy::MessageMemoryStrategy<ros_type<MessageT>, AllocatorT>>
  std::shared_ptr<Subscription<MessageT>> create_subscription(
    const std::string & topic, const QoS & qos, CallbackT && callback,
    const SubscriptionOptionsWithAllocator<AllocatorT> & options =
    SubscriptionOptionsWithAllocator<AllocatorT>(),
    std::shared_ptr<MemoryStrategyT> = nullptr)
  {
    auto subscription = std::make_shared<Subscription<MessageT>>(
      *base_, extend_name(topic), with_overrides(qos, options, topic, "subscription"),
      std::forward<CallbackT>(callback), options);
    subscription->set_node_default(options_.use_intra_process_comms());
    const auto statistics =
      options.topic_stats_options.state.maker(options_.topic_statistics());
    if (statistics) {subscription->observe(statistics(*base_, options));}
    base_->add(ExecutableKind::kSubscription, subscription, options.callback_group);
    base_->add(
      ExecutableKind::kWaitable, subscription->events(), options.callback_group);
    return subscription;
  }

  std::shared_ptr<GenericPublisher> create_generic_publisher(
    const std::string & topic, const std::string & type, const QoS & qos,
    const PublisherOptionsBase & options = PublisherOptions())
  {
    auto publisher = std::make_shared<GenericPublisher>(
      *base_, extend_name(topic), type, qos, options);
    base_->add(
      ExecutableKind::kWaitable, publisher->events(), options.callback_group);
    return publisher;
  }

  template<class CallbackT>
  std::shared_ptr<GenericSubscription> create_generic_subscription(
    const std::string & topic, const std::string & type, const QoS & qos, CallbackT && callback,
    const SubscriptionOptionsBase & options = SubscriptionOptions())
  {
    auto subscription = std::make_shared<GenericSubscription>(
      *base_, extend_name(topic), type, qos, std::forward<CallbackT>(callback), options);
    base_->add(ExecutableKind::kSubscription, subscription, options.callback_group);
    base_->add(
      ExecutableKind::kWaitable, subscription->events(), options.callback_group);
    return subscription;
  }

  template<class ServiceT, class CallbackT>
  std::shared_ptr<Service<ServiceT>> create_service(
    const std::string & name, CallbackT && callback, const QoS & qos = ServicesQoS(),
    CallbackGroup::SharedPtr group = nullptr)
  {
    auto service = std::make_shared<Service<ServiceT>>(
      *base_, extend_name(name), qos, std::forward<CallbackT>(callback));
    base_->add(ExecutableKind::kService, service, group);
    return service;
  }
  /// The signature of Humble.
  template<class ServiceT, class CallbackT>
  std::shared_ptr<Service<ServiceT>> create_service(
    const std::string & name, CallbackT && callback, const rmw_qos_profile_t & qos,
    CallbackGroup::SharedPtr group = nullptr)
  {
    return create_service<ServiceT>(
      name, std::forward<CallbackT>(callback), QoS(QoSInitialization::from_rmw(qos), qos), group);
  }

  template<class ServiceT>
  std::shared_ptr<Client<ServiceT>> create_client(
    const std::string & name, const QoS & qos = ServicesQoS(),
    CallbackGroup::SharedPtr group = nullptr)
  {
    auto client = std::make_shared<Client<ServiceT>>(*base_, extend_name(name), qos);
    base_->add(ExecutableKind::kClient, client, group);
    return client;
  }
  /// The signature of Humble.
  template<class ServiceT>
  std::shared_ptr<Client<ServiceT>> create_client(
    const std::string & name, const rmw_qos_profile_t & qos,
    CallbackGroup::SharedPtr group = nullptr)
  {
    return create_client<ServiceT>(name, QoS(QoSInitialization::from_rmw(qos), qos), group);
  }

  std::shared_ptr<GenericClient> create_generic_client(
    const std::string & name, const std::string & type, const QoS & qos = ServicesQoS(),
    CallbackGroup::SharedPtr group = nullptr)
  {
    auto client = std::make_shared<GenericClient>(*base_, extend_name(name), type, qos);
    base_->add(ExecutableKind::kClient, client, group);
    return client;
  }

  template<class CallbackT>
  std::shared_ptr<GenericService> create_generic_service(
    const std::string & name, const std::string & type, CallbackT && callback,
    const QoS & qos = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
  {
    auto service = std::make_shared<GenericService>(
      *base_, extend_name(name), type, qos, std::forward<CallbackT>(callback));
    base_->add(ExecutableKind::kService, service, group);
    return service;
  }

  template<class Rep, class Period, class CallbackT>
  typename WallTimer<CallbackT>::SharedPtr create_wall_timer(
    std::chrono::duration<Rep, Period> period, CallbackT callback,
    CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
  {
    auto timer = std::make_shared<WallTimer<CallbackT>>(
      timer_period(period), timer_callback(std::move(callback)), autostart);
    base_->add(ExecutableKind::kTimer, timer, group);
    return timer;
  }

  /// A timer on the node's clock, which may follow /clock.
  template<class Rep, class Period, class CallbackT>
  typename GenericTimer<CallbackT>::SharedPtr create_timer(
    std::chrono::duration<Rep, Period> period, CallbackT callback,
    CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
  {
    auto timer = std::make_shared<GenericTimer<CallbackT>>(
      clock_, timer_period(period), timer_callback(std::move(callback)), autostart);
    base_->add(ExecutableKind::kTimer, timer, group);
    return timer;
  }

protected:
  /// `qos` with the overrides by parameters that `options` allow.
  template<class OptionsT>
  QoS with_overrides(
    const QoS & qos, const OptionsT & options, const std::string & topic,
    const char * endpoint) const
  {
    const auto override = options.qos_overriding_options.override();
    if (!override) {return qos;}
    const auto name = base_->resolve_topic_or_service_name(extend_name(topic), false);
    return override(parameters_, options.qos_overriding_options, name, endpoint, qos);
  }

  AnyNode(
    const std::string & name, const std::string & name_space, const NodeOptions & options);
  /// Create a sub-node of `other`.
  AnyNode(const AnyNode & other, const std::string & sub_namespace);
  std::string extend_name(const std::string & name) const;

private:
  NodeOptions options_;
  std::string sub_namespace_;
  Logger logger_;
  std::shared_ptr<Rosout> rosout_;
  Clock::SharedPtr clock_;
  TimeSource::SharedPtr time_source_;
  std::shared_ptr<void> logger_services_;
};

}  // namespace detail
}  // namespace rclcpp
