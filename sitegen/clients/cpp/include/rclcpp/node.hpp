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
#include "rclcpp/detail/rosout.hpp"
#include "rclcpp/generic_publisher.hpp"
#include "rclcpp/generic_subscription.hpp"
#include "rclcpp/logger.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/node_interfaces/node_parts.hpp"
#include "rclcpp/node_options.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp/time_source.hpp"
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

  /// A node that is this one, with `sub_namespace` before its relative names.
  SharedPtr create_sub_node(const std::string & sub_namespace);
  const std::string & get_sub_namespace() const {return sub_namespace_;}
  std::string get_effective_namespace() const;

  node_interfaces::NodeClockInterface::SharedPtr get_node_clock_interface()
  {
    return std::make_shared<node_interfaces::NodeClockInterface>(clock_);
  }
  node_interfaces::NodeGraphInterface::SharedPtr get_node_graph_interface()
  {
    return std::make_shared<node_interfaces::NodeGraphInterface>(base_);
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
      *base_, extend_name(topic), qos, options);
    base_->add(
      detail::ExecutableKind::kWaitable, publisher->events(), options.callback_group);
    return publisher;
  }

  template<class MessageT, class CallbackT, class AllocatorT = std::allocator<void>>
  std::shared_ptr<Subscription<MessageT>> create_subscription(
    const std::string & topic, const QoS & qos, CallbackT && callback,
    const SubscriptionOptionsWithAllocator<AllocatorT> & options =
    SubscriptionOptionsWithAllocator<AllocatorT>())
  {
    auto subscription = std::make_shared<Subscription<MessageT>>(
      *base_, extend_name(topic), qos, std::forward<CallbackT>(callback), options);
    base_->add(detail::ExecutableKind::kSubscription, subscription, options.callback_group);
    base_->add(
      detail::ExecutableKind::kWaitable, subscription->events(), options.callback_group);
    return subscription;
  }

  std::shared_ptr<GenericPublisher> create_generic_publisher(
    const std::string & topic, const std::string & type, const QoS & qos,
    const PublisherOptionsBase & options = PublisherOptions())
  {
    auto publisher = std::make_shared<GenericPublisher>(
      *base_, extend_name(topic), type, qos, options);
    base_->add(
      detail::ExecutableKind::kWaitable, publisher->events(), options.callback_group);
    return publisher;
  }

  template<class CallbackT>
  std::shared_ptr<GenericSubscription> create_generic_subscription(
    const std::string & topic, const std::string & type, const QoS & qos, CallbackT && callback,
    const SubscriptionOptionsBase & options = SubscriptionOptions())
  {
    auto subscription = std::make_shared<GenericSubscription>(
      *base_, extend_name(topic), type, qos, std::forward<CallbackT>(callback), options);
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
      *base_, extend_name(name), qos, std::forward<CallbackT>(callback));
    base_->add(detail::ExecutableKind::kService, service, group);
    return service;
  }
  /// The form of Humble.
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
    base_->add(detail::ExecutableKind::kClient, client, group);
    return client;
  }
  /// The form of Humble.
  template<class ServiceT>
  std::shared_ptr<Client<ServiceT>> create_client(
    const std::string & name, const rmw_qos_profile_t & qos,
    CallbackGroup::SharedPtr group = nullptr)
  {
    return create_client<ServiceT>(name, QoS(QoSInitialization::from_rmw(qos), qos), group);
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

  using Descriptor = rcl_interfaces::msg::ParameterDescriptor;
  using SetParametersResult = rcl_interfaces::msg::SetParametersResult;
  using PreSetParametersCallbackHandle = node_interfaces::PreSetParametersCallbackHandle;
  using OnSetParametersCallbackHandle = node_interfaces::OnSetParametersCallbackHandle;
  using PostSetParametersCallbackHandle = node_interfaces::PostSetParametersCallbackHandle;
  using PreSetParametersCallbackType = node_interfaces::PreSetCallbackType;
  using OnSetParametersCallbackType = node_interfaces::OnSetCallbackType;
  using PostSetParametersCallbackType = node_interfaces::PostSetCallbackType;

  const ParameterValue & declare_parameter(
    const std::string & name, const ParameterValue & default_value,
    const Descriptor & descriptor = Descriptor(), bool ignore_override = false)
  {
    return parameters_->declare_parameter(
      name, default_value, descriptor, ignore_override);
  }
  const ParameterValue & declare_parameter(
    const std::string & name, ParameterType type, const Descriptor & descriptor = Descriptor(),
    bool ignore_override = false)
  {
    return parameters_->declare_parameter(name, type, descriptor, ignore_override);
  }
  template<class ParameterT>
  auto declare_parameter(
    const std::string & name, const ParameterT & default_value,
    const Descriptor & descriptor = Descriptor(), bool ignore_override = false)
  {
    using Value = std::conditional_t<
      std::is_convertible_v<ParameterT, std::string>, std::string, std::decay_t<ParameterT>>;
    try {
      return Value(
        declare_parameter(name, ParameterValue(default_value), descriptor, ignore_override)
        .template get<Value>());
    } catch (const ParameterTypeException & error) {
      throw exceptions::InvalidParameterTypeException(name, error.what());
    }
  }
  /// Without a default: it has to be overridden, or set before it is read.
  template<class ParameterT>
  ParameterT declare_parameter(
    const std::string & name, const Descriptor & descriptor = Descriptor(),
    bool ignore_override = false)
  {
    const ParameterValue & value = declare_parameter(
      name, ParameterValue::type_of<ParameterT>(), descriptor, ignore_override);
    if (value.get_type() == PARAMETER_NOT_SET) {
      throw exceptions::ParameterUninitializedException(name);
    }
    return value.get<ParameterT>();
  }
  template<class ParameterT>
  std::vector<ParameterT> declare_parameters(
    const std::string & name_space, const std::map<std::string, ParameterT> & parameters,
    bool ignore_overrides = false)
  {
    std::vector<ParameterT> values;
    const std::string start = name_space.empty() ? "" : name_space + ".";
    for (const auto & [name, value] : parameters) {
      values.push_back(declare_parameter(start + name, value, Descriptor(), ignore_overrides));
    }
    return values;
  }
  template<class ParameterT>
  std::vector<ParameterT> declare_parameters(
    const std::string & name_space,
    const std::map<std::string, std::pair<ParameterT, Descriptor>> & parameters,
    bool ignore_overrides = false)
  {
    std::vector<ParameterT> values;
    const std::string start = name_space.empty() ? "" : name_space + ".";
    for (const auto & [name, pair] : parameters) {
      values.push_back(
        declare_parameter(start + name, pair.first, pair.second, ignore_overrides));
    }
    return values;
  }
  void undeclare_parameter(const std::string & name)
  {
    parameters_->undeclare_parameter(name);
  }
  bool has_parameter(const std::string & name) const
  {
    return parameters_->has_parameter(name);
  }
  SetParametersResult set_parameter(const Parameter & parameter)
  {
    return set_parameters_atomically({parameter});
  }
  std::vector<SetParametersResult> set_parameters(const std::vector<Parameter> & parameters)
  {
    return parameters_->set_parameters(parameters);
  }
  SetParametersResult set_parameters_atomically(const std::vector<Parameter> & parameters)
  {
    return parameters_->set_parameters_atomically(parameters);
  }
  Parameter get_parameter(const std::string & name) const
  {
    return parameters_->get_parameter(name);
  }
  bool get_parameter(const std::string & name, Parameter & parameter) const
  {
    return parameters_->get_parameter(name, parameter);
  }
  template<class ParameterT>
  bool get_parameter(const std::string & name, ParameterT & value) const
  {
    Parameter parameter;
    if (!get_parameter(name, parameter)) {return false;}
    value = static_cast<ParameterT>(parameter.get_value<ParameterT>());
    return true;
  }
  template<class ParameterT>
  bool get_parameter_or(
    const std::string & name, ParameterT & value, const ParameterT & alternative) const
  {
    const bool found = get_parameter(name, value);
    if (!found) {value = alternative;}
    return found;
  }
  template<class ParameterT>
  ParameterT get_parameter_or(const std::string & name, const ParameterT & alternative) const
  {
    ParameterT value{};
    get_parameter_or(name, value, alternative);
    return value;
  }
  std::vector<Parameter> get_parameters(const std::vector<std::string> & names) const
  {
    return parameters_->get_parameters(names);
  }
  template<class ParameterT>
  bool get_parameters(
    const std::string & prefix, std::map<std::string, ParameterT> & values) const
  {
    std::map<std::string, Parameter> found;
    const bool any = parameters_->get_parameters_by_prefix(prefix, found);
    for (const auto & [name, parameter] : found) {
      values[name] = static_cast<ParameterT>(parameter.get_value<ParameterT>());
    }
    return any;
  }
  Descriptor describe_parameter(const std::string & name) const
  {
    return describe_parameters({name}).at(0);
  }
  std::vector<Descriptor> describe_parameters(const std::vector<std::string> & names) const
  {
    return parameters_->describe_parameters(names);
  }
  std::vector<std::uint8_t> get_parameter_types(const std::vector<std::string> & names) const
  {
    return parameters_->get_parameter_types(names);
  }
  rcl_interfaces::msg::ListParametersResult list_parameters(
    const std::vector<std::string> & prefixes, std::uint64_t depth) const
  {
    return parameters_->list_parameters(prefixes, depth);
  }
  template<class CallbackT>
  PreSetParametersCallbackHandle::SharedPtr add_pre_set_parameters_callback(CallbackT && callback)
  {
    return parameters_->add_pre_set_parameters_callback(std::forward<CallbackT>(callback));
  }
  template<class CallbackT>
  OnSetParametersCallbackHandle::SharedPtr add_on_set_parameters_callback(CallbackT && callback)
  {
    return parameters_->add_on_set_parameters_callback(std::forward<CallbackT>(callback));
  }
  template<class CallbackT>
  PostSetParametersCallbackHandle::SharedPtr add_post_set_parameters_callback(
    CallbackT && callback)
  {
    return parameters_->add_post_set_parameters_callback(std::forward<CallbackT>(callback));
  }
  void remove_pre_set_parameters_callback(const PreSetParametersCallbackHandle * handle)
  {
    parameters_->remove_pre_set_parameters_callback(handle);
  }
  void remove_on_set_parameters_callback(const OnSetParametersCallbackHandle * handle)
  {
    parameters_->remove_on_set_parameters_callback(handle);
  }
  void remove_post_set_parameters_callback(const PostSetParametersCallbackHandle * handle)
  {
    parameters_->remove_post_set_parameters_callback(handle);
  }
  node_interfaces::NodeParametersInterface::SharedPtr get_node_parameters_interface()
  {
    return node_interfaces::NodeParametersInterface::linked(parameters_);
  }

protected:
  /// Make a node that is `other` with more of a namespace.
  Node(const Node & other, const std::string & sub_namespace);
  std::string extend_name(const std::string & name) const;

private:
  NodeOptions options_;
  std::string sub_namespace_;
  node_interfaces::NodeBaseInterface::SharedPtr base_;
  Logger logger_;
  std::shared_ptr<detail::Rosout> rosout_;
  Clock::SharedPtr clock_;
  node_interfaces::NodeParametersInterface::SharedPtr parameters_;
  TimeSource::SharedPtr time_source_;
};

}  // namespace rclcpp
