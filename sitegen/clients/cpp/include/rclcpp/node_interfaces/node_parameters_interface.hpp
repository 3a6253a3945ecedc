#pragma once

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "rcl_interfaces/msg/list_parameters_result.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rcl_interfaces/msg/set_parameters_result.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_options.hpp"
#include "rclcpp/parameter.hpp"
#include "rclcpp/publisher.hpp"

namespace rclcpp
{
namespace detail
{
class ParameterServices;
}  // namespace detail

namespace node_interfaces
{

/// A callback that is removed with its handle.
template<class CallbackT>
struct ParameterCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterCallbackHandle<CallbackT>)

  using CallbackType = CallbackT;
  using OnSetParametersCallbackType = CallbackT;
  using OnParametersSetCallbackType = CallbackT;
  CallbackT callback;
};

using PreSetCallbackType = std::function<void (std::vector<Parameter> &)>;
using OnSetCallbackType =
  std::function<rcl_interfaces::msg::SetParametersResult (const std::vector<Parameter> &)>;
using PostSetCallbackType = std::function<void (const std::vector<Parameter> &)>;

using PreSetParametersCallbackHandle = ParameterCallbackHandle<PreSetCallbackType>;
using OnSetParametersCallbackHandle = ParameterCallbackHandle<OnSetCallbackType>;
using PostSetParametersCallbackHandle = ParameterCallbackHandle<PostSetCallbackType>;

/// The parameters of a node.
class NodeParametersInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeParametersInterface)
  RCLCPP_DISABLE_COPY(NodeParametersInterface)

  using Descriptor = rcl_interfaces::msg::ParameterDescriptor;
  using SetResult = rcl_interfaces::msg::SetParametersResult;
  using PreSetParametersCallbackType = PreSetCallbackType;
  using OnSetParametersCallbackType = OnSetCallbackType;
  using OnParametersSetCallbackType = OnSetCallbackType;
  using PostSetParametersCallbackType = PostSetCallbackType;

  NodeParametersInterface(NodeBaseInterface::SharedPtr node, const NodeOptions & options);
  ~NodeParametersInterface();

  /// Return `parameters`. A call of this function links the implementation of parameters.
  static SharedPtr linked(SharedPtr parameters);

  const ParameterValue & declare_parameter(
    const std::string & name, const ParameterValue & default_value,
    const Descriptor & descriptor = Descriptor(), bool ignore_override = false);
  const ParameterValue & declare_parameter(
    const std::string & name, ParameterType type, const Descriptor & descriptor = Descriptor(),
    bool ignore_override = false);
  void undeclare_parameter(const std::string & name);
  bool has_parameter(const std::string & name) const {return parameters_.count(name) != 0;}

  std::vector<SetResult> set_parameters(const std::vector<Parameter> & parameters);
  SetResult set_parameters_atomically(const std::vector<Parameter> & parameters);
  std::vector<Parameter> get_parameters(const std::vector<std::string> & names) const;
  Parameter get_parameter(const std::string & name) const;
  bool get_parameter(const std::string & name, Parameter & parameter) const;
  bool get_parameters_by_prefix(
    const std::string & prefix, std::map<std::string, Parameter> & parameters) const;
  std::vector<Descriptor> describe_parameters(const std::vector<std::string> & names) const;
  std::vector<std::uint8_t> get_parameter_types(const std::vector<std::string> & names) const;
  rcl_interfaces::msg::ListParametersResult list_parameters(
    const std::vector<std::string> & prefixes, std::uint64_t depth) const;

  PreSetParametersCallbackHandle::SharedPtr add_pre_set_parameters_callback(
    PreSetCallbackType callback);
  OnSetParametersCallbackHandle::SharedPtr add_on_set_parameters_callback(
    OnSetCallbackType callback);
  PostSetParametersCallbackHandle::SharedPtr add_post_set_parameters_callback(
    PostSetCallbackType callback);
  void remove_pre_set_parameters_callback(const PreSetParametersCallbackHandle * handle);
  void remove_on_set_parameters_callback(const OnSetParametersCallbackHandle * handle);
  void remove_post_set_parameters_callback(const PostSetParametersCallbackHandle * handle);
  const std::map<std::string, ParameterValue> & get_parameter_overrides() const
  {
    return overrides_;
  }

private:
  struct Info
  {
    ParameterValue value;
    Descriptor descriptor;
  };
  using Infos = std::map<std::string, Info>;
  template<class HandleT>
  using Handles = std::list<std::weak_ptr<HandleT>>;

  const ParameterValue & declare(
    const std::string & name, const ParameterValue & default_value, Descriptor descriptor,
    bool ignore_override);
  /// Check the changes and call the callbacks; then set `parameters` in `infos`. `declaring`
  /// parameters are not in it yet.
  SetResult apply(
    const std::vector<Parameter> & parameters, Infos & infos, bool call_pre_and_post);
  SetResult set_all(std::vector<Parameter> parameters);
  void publish_event(rcl_interfaces::msg::ParameterEvent & event);

  NodeBaseInterface::SharedPtr node_;
  bool allow_undeclared_;
  bool modifying_ = false;
  Infos parameters_;
  std::map<std::string, ParameterValue> overrides_;
  Handles<PreSetParametersCallbackHandle> pre_set_;
  Handles<OnSetParametersCallbackHandle> on_set_;
  Handles<PostSetParametersCallbackHandle> post_set_;
  std::shared_ptr<Publisher<rcl_interfaces::msg::ParameterEvent>> events_;
  std::shared_ptr<detail::ParameterServices> services_;
};

}  // namespace node_interfaces
}  // namespace rclcpp
