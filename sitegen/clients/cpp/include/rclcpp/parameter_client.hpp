#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rcl_interfaces/srv/describe_parameters.hpp"
#include "rcl_interfaces/srv/get_parameter_types.hpp"
#include "rcl_interfaces/srv/get_parameters.hpp"
#include "rcl_interfaces/srv/list_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters_atomically.hpp"
#include "rclcpp/executors.hpp"
#include "rclcpp/node.hpp"
#include "rclcpp/parameter_map.hpp"

namespace rclcpp
{

/// Gets and sets the parameters of a node.
class AsyncParametersClient
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(AsyncParametersClient)

  using SetResult = rcl_interfaces::msg::SetParametersResult;
  template<class T>
  using Callback = std::function<void (std::shared_future<T>)>;

  /// `remote` is the name of the node; if empty, that of `node`.
  template<class NodeT>
  explicit AsyncParametersClient(
    NodeT node, const std::string & remote = "", const QoS & qos = ParametersQoS(),
    CallbackGroup::SharedPtr group = nullptr)
  : AsyncParametersClient(node->get_node_base_interface(), remote, qos, group) {}
  AsyncParametersClient(
    node_interfaces::NodeBaseInterface::SharedPtr node, const std::string & remote,
    const QoS & qos, CallbackGroup::SharedPtr group);
  /// As upstream, for node interfaces. The base interface does the work of the others.
  AsyncParametersClient(
    node_interfaces::NodeBaseInterface::SharedPtr base,
    node_interfaces::NodeTopicsInterface::SharedPtr,
    node_interfaces::NodeGraphInterface::SharedPtr,
    node_interfaces::NodeServicesInterface::SharedPtr, const std::string & remote = "",
    const QoS & qos = ParametersQoS(), CallbackGroup::SharedPtr group = nullptr)
  : AsyncParametersClient(std::move(base), remote, qos, std::move(group)) {}
  /// The signatures of Humble.
  AsyncParametersClient(
    node_interfaces::NodeBaseInterface::SharedPtr base,
    node_interfaces::NodeTopicsInterface::SharedPtr,
    node_interfaces::NodeGraphInterface::SharedPtr,
    node_interfaces::NodeServicesInterface::SharedPtr, const std::string & remote,
    const rmw_qos_profile_t & qos, CallbackGroup::SharedPtr group = nullptr)
  : AsyncParametersClient(
      std::move(base), remote, QoS(QoSInitialization::from_rmw(qos), qos), std::move(group)) {}
  template<class NodeT>
  AsyncParametersClient(
    NodeT node, const std::string & remote, const rmw_qos_profile_t & qos,
    CallbackGroup::SharedPtr group = nullptr)
  : AsyncParametersClient(
      node->get_node_base_interface(), remote, QoS(QoSInitialization::from_rmw(qos), qos),
      std::move(group)) {}

  std::shared_future<std::vector<Parameter>> get_parameters(
    const std::vector<std::string> & names, Callback<std::vector<Parameter>> callback = nullptr);
  std::shared_future<std::vector<rcl_interfaces::msg::ParameterDescriptor>> describe_parameters(
    const std::vector<std::string> & names,
    Callback<std::vector<rcl_interfaces::msg::ParameterDescriptor>> callback = nullptr);
  std::shared_future<std::vector<ParameterType>> get_parameter_types(
    const std::vector<std::string> & names,
    Callback<std::vector<ParameterType>> callback = nullptr);
  std::shared_future<std::vector<SetResult>> set_parameters(
    const std::vector<Parameter> & parameters, Callback<std::vector<SetResult>> callback = nullptr);
  std::shared_future<SetResult> set_parameters_atomically(
    const std::vector<Parameter> & parameters, Callback<SetResult> callback = nullptr);
  /// Set each parameter to "not set".
  std::shared_future<std::vector<SetResult>> delete_parameters(
    const std::vector<std::string> & names);
  /// Set the parameters of a file or a map; throws InvalidParametersException if none is for the node.
  std::shared_future<std::vector<SetResult>> load_parameters(const std::string & yaml_filename);
  std::shared_future<std::vector<SetResult>> load_parameters(const ParameterMap & parameter_map);
  std::shared_future<rcl_interfaces::msg::ListParametersResult> list_parameters(
    const std::vector<std::string> & prefixes, std::uint64_t depth,
    Callback<rcl_interfaces::msg::ListParametersResult> callback = nullptr);

  template<class CallbackT>
  std::shared_ptr<Subscription<rcl_interfaces::msg::ParameterEvent>> on_parameter_event(
    CallbackT && callback, const QoS & qos = ParameterEventsQoS())
  {
    return on_parameter_event(node_, std::forward<CallbackT>(callback), qos);
  }
  /// `node` is a pointer of any kind to a node or to its topics interface.
  template<
    class NodeT, class CallbackT,
    class = decltype(std::declval<NodeT &>()->get_node_base_interface())>
  static std::shared_ptr<Subscription<rcl_interfaces::msg::ParameterEvent>> on_parameter_event(
    NodeT node, CallbackT && callback, const QoS & qos = ParameterEventsQoS())
  {
    auto base = node->get_node_base_interface();
    auto subscription = std::make_shared<Subscription<rcl_interfaces::msg::ParameterEvent>>(
      *base, "/parameter_events", qos, std::forward<CallbackT>(callback));
    base->add(detail::ExecutableKind::kSubscription, subscription);
    return subscription;
  }

  bool service_is_ready() const;
  template<class Rep = std::int64_t, class Period = std::milli>
  bool wait_for_service(
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    for (const auto & client : clients_) {
      if (!client->wait_for_service(timeout)) {return false;}
    }
    return true;
  }

private:
  template<class ServiceT>
  std::shared_ptr<Client<ServiceT>> make(
    const std::string & remote, const char * name, const QoS & qos,
    const CallbackGroup::SharedPtr & group);

  node_interfaces::NodeBaseInterface::SharedPtr node_;
  std::string remote_;
  std::vector<std::shared_ptr<ClientBase>> clients_;
  std::shared_ptr<Client<rcl_interfaces::srv::GetParameters>> get_;
  std::shared_ptr<Client<rcl_interfaces::srv::GetParameterTypes>> types_;
  std::shared_ptr<Client<rcl_interfaces::srv::SetParameters>> set_;
  std::shared_ptr<Client<rcl_interfaces::srv::SetParametersAtomically>> set_atomically_;
  std::shared_ptr<Client<rcl_interfaces::srv::DescribeParameters>> describe_;
  std::shared_ptr<Client<rcl_interfaces::srv::ListParameters>> list_;
};

/// The same, but spins the node until the response arrives.
class SyncParametersClient
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SyncParametersClient)

  using SetResult = rcl_interfaces::msg::SetParametersResult;
  using Timeout = std::chrono::nanoseconds;

  /// `node` is a pointer of any kind.
  template<class NodeT>
  explicit SyncParametersClient(
    NodeT node, const std::string & remote = "", const QoS & qos = ParametersQoS())
  : SyncParametersClient(
      std::make_shared<executors::SingleThreadedExecutor>(), node, remote, qos) {}
  template<class NodeT>
  SyncParametersClient(
    Executor::SharedPtr executor, NodeT node, const std::string & remote = "",
    const QoS & qos = ParametersQoS())
  : executor_(std::move(executor)), node_(node->get_node_base_interface()),
    client_(std::make_shared<AsyncParametersClient>(node_, remote, qos)) {}
  /// As upstream, for node interfaces.
  SyncParametersClient(
    Executor::SharedPtr executor, node_interfaces::NodeBaseInterface::SharedPtr base,
    node_interfaces::NodeTopicsInterface::SharedPtr,
    node_interfaces::NodeGraphInterface::SharedPtr,
    node_interfaces::NodeServicesInterface::SharedPtr, const std::string & remote = "",
    const QoS & qos = ParametersQoS())
  : SyncParametersClient(std::move(executor), std::move(base), remote, qos) {}
  /// The signatures of Humble.
  SyncParametersClient(
    Executor::SharedPtr executor, node_interfaces::NodeBaseInterface::SharedPtr base,
    node_interfaces::NodeTopicsInterface::SharedPtr,
    node_interfaces::NodeGraphInterface::SharedPtr,
    node_interfaces::NodeServicesInterface::SharedPtr, const std::string & remote,
    const rmw_qos_profile_t & qos)
  : SyncParametersClient(std::move(executor), std::move(base), remote, qos) {}
  template<class NodeT>
  SyncParametersClient(NodeT node, const std::string & remote, const rmw_qos_profile_t & qos)
  : SyncParametersClient(node, remote, QoS(QoSInitialization::from_rmw(qos), qos)) {}
  template<class NodeT>
  SyncParametersClient(
    Executor::SharedPtr executor, NodeT node, const std::string & remote,
    const rmw_qos_profile_t & qos)
  : SyncParametersClient(
      std::move(executor), node, remote, QoS(QoSInitialization::from_rmw(qos), qos)) {}

  std::vector<Parameter> get_parameters(
    const std::vector<std::string> & names, Timeout timeout = Timeout(-1))
  {
    return wait(client_->get_parameters(names), timeout);
  }
  bool has_parameter(const std::string & name)
  {
    return !list_parameters({name}, 1).names.empty();
  }
  template<class T>
  T get_parameter(const std::string & name, const T & default_value)
  {
    return get_parameter_impl<T>(name, [&]() -> T {return default_value;});
  }
  template<class T>
  T get_parameter(const std::string & name)
  {
    return get_parameter_impl<T>(
      name, [&]() -> T {throw std::runtime_error("Parameter '" + name + "' is not set");});
  }
  std::vector<rcl_interfaces::msg::ParameterDescriptor> describe_parameters(
    const std::vector<std::string> & names, Timeout timeout = Timeout(-1))
  {
    return wait(client_->describe_parameters(names), timeout);
  }
  std::vector<ParameterType> get_parameter_types(
    const std::vector<std::string> & names, Timeout timeout = Timeout(-1))
  {
    return wait(client_->get_parameter_types(names), timeout);
  }
  std::vector<SetResult> set_parameters(
    const std::vector<Parameter> & parameters, Timeout timeout = Timeout(-1))
  {
    return wait(client_->set_parameters(parameters), timeout);
  }
  SetResult set_parameters_atomically(
    const std::vector<Parameter> & parameters, Timeout timeout = Timeout(-1))
  {
    return wait(client_->set_parameters_atomically(parameters), timeout);
  }
  std::vector<SetResult> delete_parameters(
    const std::vector<std::string> & names, Timeout timeout = Timeout(-1))
  {
    return wait(client_->delete_parameters(names), timeout);
  }
  /// From a file or a map.
  template<class SourceT>
  std::vector<SetResult> load_parameters(const SourceT & source, Timeout timeout = Timeout(-1))
  {
    return wait(client_->load_parameters(source), timeout);
  }
  rcl_interfaces::msg::ListParametersResult list_parameters(
    const std::vector<std::string> & prefixes, std::uint64_t depth, Timeout timeout = Timeout(-1))
  {
    return wait(client_->list_parameters(prefixes, depth), timeout);
  }
  template<class CallbackT>
  auto on_parameter_event(CallbackT && callback)
  {
    return client_->on_parameter_event(std::forward<CallbackT>(callback));
  }
  bool service_is_ready() const {return client_->service_is_ready();}
  template<class Rep = std::int64_t, class Period = std::milli>
  bool wait_for_service(
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return client_->wait_for_service(timeout);
  }

private:
  template<class T>
  T wait(const std::shared_future<T> & future, Timeout timeout)
  {
    const auto code =
      executors::spin_node_until_future_complete(*executor_, node_, future, timeout);
    return code == FutureReturnCode::SUCCESS ? future.get() : T();
  }
  template<class T, class OtherwiseT>
  T get_parameter_impl(const std::string & name, OtherwiseT otherwise)
  {
    const auto found = get_parameters({name});
    const bool is_set = found.size() == 1 && found[0].get_type() != PARAMETER_NOT_SET;
    return is_set ? static_cast<T>(found[0].get_value<T>()) : otherwise();
  }

  Executor::SharedPtr executor_;
  node_interfaces::NodeBaseInterface::SharedPtr node_;
  AsyncParametersClient::SharedPtr client_;
};

}  // namespace rclcpp
