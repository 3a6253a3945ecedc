// The methods of a node about its parameters.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "rclcpp/exceptions.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"

namespace rclcpp
{
namespace detail
{

// Outside the class, where they would hide functions with these names in user code.
using Descriptor = rcl_interfaces::msg::ParameterDescriptor;
using SetResult = rcl_interfaces::msg::SetParametersResult;

class HasParameters
{
public:
  using PreSetParametersCallbackHandle = node_interfaces::PreSetParametersCallbackHandle;
  using OnSetParametersCallbackHandle = node_interfaces::OnSetParametersCallbackHandle;
  using PostSetParametersCallbackHandle = node_interfaces::PostSetParametersCallbackHandle;
  using PreSetParametersCallbackType = node_interfaces::PreSetCallbackType;
  using OnSetParametersCallbackType = node_interfaces::OnSetCallbackType;
  using OnParametersSetCallbackType = OnSetParametersCallbackType;
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
  /// Without a default value: it must be overridden, or set before it is read.
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
  SetResult set_parameter(const Parameter & parameter)
  {
    return set_parameters_atomically({parameter});
  }
  std::vector<SetResult> set_parameters(const std::vector<Parameter> & parameters)
  {
    return parameters_->set_parameters(parameters);
  }
  SetResult set_parameters_atomically(const std::vector<Parameter> & parameters)
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
  PreSetParametersCallbackHandle::SharedPtr add_pre_set_parameters_callback(
    PreSetParametersCallbackType callback)
  {
    return parameters_->add_pre_set_parameters_callback(std::move(callback));
  }
  OnSetParametersCallbackHandle::SharedPtr add_on_set_parameters_callback(
    OnSetParametersCallbackType callback)
  {
    return parameters_->add_on_set_parameters_callback(std::move(callback));
  }
  PostSetParametersCallbackHandle::SharedPtr add_post_set_parameters_callback(
    PostSetParametersCallbackType callback)
  {
    return parameters_->add_post_set_parameters_callback(std::move(callback));
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
  node_interfaces::NodeParametersInterface::SharedPtr parameters_;
};

}  // namespace detail
}  // namespace rclcpp
