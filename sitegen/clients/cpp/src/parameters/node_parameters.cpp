#include "rclcpp/node_interfaces/node_parameters_interface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rclcpp/clock.hpp"
#include "rclcpp/detail/node_parameters.hpp"
#include "rclcpp/detail/parameter_services.hpp"
#include "parameter_overrides.hpp"

namespace rclcpp
{
namespace node_interfaces
{

namespace
{

using SetResult = NodeParametersInterface::SetResult;
using Descriptor = NodeParametersInterface::Descriptor;
using exceptions::ParameterNotDeclaredException;

SetResult refused(std::string reason)
{
  SetResult result;
  result.successful = false;
  result.reason = std::move(reason);
  return result;
}

SetResult accepted()
{
  SetResult result;
  result.successful = true;
  return result;
}

template<class RangeT, class T>
bool is_in(const RangeT & range, T value)
{
  if (value == range.from_value || value == range.to_value) {return true;}
  if (value < range.from_value || value > range.to_value) {return false;}
  if (range.step == 0) {return true;}
  if constexpr (std::is_integral_v<T>) {
    return (value - range.from_value) % static_cast<T>(range.step) == 0;
  } else {
    const double steps = std::round((value - range.from_value) / range.step);
    const double nearest = range.from_value + steps * range.step;
    return std::abs(value - nearest) <= 1e-9 * std::max(1.0, std::abs(value));
  }
}

/// Check a value against its descriptor.
SetResult check(const std::string & name, const ParameterValue & value, const Descriptor & descriptor)
{
  const auto type = value.get_type();
  if (!descriptor.dynamic_typing && descriptor.type != type) {
    return refused(
      "Wrong parameter type, parameter {" + name + "} is of type {" +
      to_string(static_cast<ParameterType>(descriptor.type)) + "}, setting it to {" +
      to_string(type) + "} is not allowed.");
  }
  if (type == PARAMETER_INTEGER && !descriptor.integer_range.empty() &&
    !is_in(descriptor.integer_range[0], value.get<std::int64_t>()))
  {
    return refused("Parameter {" + name + "} doesn't comply with integer range.");
  }
  if (type == PARAMETER_DOUBLE && !descriptor.floating_point_range.empty() &&
    !is_in(descriptor.floating_point_range[0], value.get<double>()))
  {
    return refused("Parameter {" + name + "} doesn't comply with floating point range.");
  }
  return accepted();
}

template<class HandleT>
std::vector<std::shared_ptr<HandleT>> living(std::list<std::weak_ptr<HandleT>> & handles)
{
  std::vector<std::shared_ptr<HandleT>> found;
  handles.remove_if([&found](const std::weak_ptr<HandleT> & handle) {
      auto locked = handle.lock();
      if (locked) {found.push_back(std::move(locked));}
      return handle.expired();
    });
  return found;
}

template<class HandleT, class CallbackT>
std::shared_ptr<HandleT> add(std::list<std::weak_ptr<HandleT>> & handles, CallbackT callback)
{
  auto handle = std::make_shared<HandleT>();
  handle->callback = std::move(callback);
  handles.emplace_front(handle);  // called in reverse order of registration
  return handle;
}

template<class HandleT>
void remove(std::list<std::weak_ptr<HandleT>> & handles, const HandleT * handle)
{
  const auto is_it = [handle](const auto & one) {return one.lock().get() == handle;};
  const auto found = std::find_if(handles.begin(), handles.end(), is_it);
  if (found == handles.end()) {throw std::runtime_error("Callback doesn't exist");}
  handles.erase(found);
}

/// Prevents callbacks from changing parameters.
class Modifying
{
public:
  explicit Modifying(bool & flag)
  : flag_(flag)
  {
    if (flag_) {
      throw exceptions::ParameterModifiedInCallbackException(
              "cannot set or declare a parameter, or change the callback from within set callback");
    }
    flag_ = true;
  }
  ~Modifying() {flag_ = false;}

private:
  bool & flag_;
};

}  // namespace

NodeParametersInterface::NodeParametersInterface(
  NodeBaseInterface::SharedPtr node, const NodeOptions & options)
: node_(std::move(node)), allow_undeclared_(options.allow_undeclared_parameters())
{
  overrides_ = detail::overrides_of(node_->arguments(), node_->get_fully_qualified_name());
  for (const auto & parameter : options.parameter_overrides()) {
    overrides_[parameter.get_name()] = parameter.get_parameter_value();
  }
  if (options.start_parameter_event_publisher()) {
    events_ = std::make_shared<Publisher<rcl_interfaces::msg::ParameterEvent>>(
      *node_, "/parameter_events", options.parameter_event_qos());
  }
  if (options.start_parameter_services()) {
    services_ = std::make_shared<detail::ParameterServices>(*node_, *this);
  }
  if (options.automatically_declare_parameters_from_overrides()) {
    Descriptor descriptor;
    descriptor.dynamic_typing = true;
    for (const auto & [name, value] : overrides_) {
      if (!has_parameter(name)) {declare(name, value, descriptor, true);}
    }
  }
}

NodeParametersInterface::~NodeParametersInterface() = default;

const ParameterValue & NodeParametersInterface::declare_parameter(
  const std::string & name, const ParameterValue & default_value, const Descriptor & descriptor,
  bool ignore_override)
{
  return declare(name, default_value, descriptor, ignore_override);
}

const ParameterValue & NodeParametersInterface::declare_parameter(
  const std::string & name, ParameterType type, const Descriptor & descriptor,
  bool ignore_override)
{
  if (type == PARAMETER_NOT_SET) {
    throw std::invalid_argument(
            "declare_parameter(): the provided parameter type cannot be "
            "rclcpp::PARAMETER_NOT_SET");
  }
  if (descriptor.dynamic_typing) {
    throw std::invalid_argument(
            "declare_parameter(): cannot declare parameter of specific type and pass descriptor "
            "with `dynamic_typing=true`");
  }
  Descriptor typed = descriptor;
  typed.type = type;
  return declare(name, ParameterValue(), typed, ignore_override);
}

const ParameterValue & NodeParametersInterface::declare(
  const std::string & name, const ParameterValue & default_value, Descriptor descriptor,
  bool ignore_override)
{
  Modifying modifying(modifying_);
  if (name.empty()) {
    throw exceptions::InvalidParametersException("parameter name must not be empty");
  }
  if (has_parameter(name)) {
    throw exceptions::ParameterAlreadyDeclaredException(
            "parameter '" + name + "' has already been declared");
  }
  if (!descriptor.dynamic_typing && descriptor.type == PARAMETER_NOT_SET) {
    descriptor.type = default_value.get_type();
    if (descriptor.type == PARAMETER_NOT_SET) {
      throw exceptions::InvalidParameterTypeException(
              name, "cannot declare a statically typed parameter with an uninitialized value");
    }
  }
  descriptor.name = name;
  const auto override = overrides_.find(name);
  const bool overridden = !ignore_override && override != overrides_.end();
  const ParameterValue value = overridden ? override->second : default_value;
  Infos declared;
  declared[name].descriptor = descriptor;
  if (value.get_type() == PARAMETER_NOT_SET && !descriptor.dynamic_typing) {
    // The value is set later, and must then have this type.
    parameters_.insert(*declared.begin());
    return parameters_.at(name).value;
  }
  const auto result = apply({Parameter(name, value)}, declared, false);
  if (!result.successful) {
    const bool of_type = !descriptor.dynamic_typing && descriptor.type != value.get_type();
    if (of_type) {throw exceptions::InvalidParameterTypeException(name, result.reason);}
    throw exceptions::InvalidParameterValueException(
            "parameter '" + name + "' could not be set: " + result.reason);
  }
  parameters_.insert(*declared.begin());
  rcl_interfaces::msg::ParameterEvent event;
  event.new_parameters.push_back(Parameter(name, value).to_parameter_msg());
  publish_event(event);
  return parameters_.at(name).value;
}

void NodeParametersInterface::undeclare_parameter(const std::string & name)
{
  Modifying modifying(modifying_);
  const auto found = parameters_.find(name);
  if (found == parameters_.end()) {
    throw ParameterNotDeclaredException(
            "cannot undeclare parameter '" + name + "' which has not yet been declared");
  }
  if (found->second.descriptor.read_only) {
    throw exceptions::ParameterImmutableException(
            "cannot undeclare parameter '" + name + "' because it is read-only");
  }
  if (!found->second.descriptor.dynamic_typing) {
    throw exceptions::InvalidParameterTypeException(
            name, "cannot undeclare a statically typed parameter");
  }
  parameters_.erase(found);
}

std::vector<SetResult> NodeParametersInterface::set_parameters(
  const std::vector<Parameter> & parameters)
{
  std::vector<SetResult> results;
  for (const auto & parameter : parameters) {results.push_back(set_all({parameter}));}
  return results;
}

SetResult NodeParametersInterface::set_parameters_atomically(
  const std::vector<Parameter> & parameters)
{
  return set_all(parameters);
}

SetResult NodeParametersInterface::set_all(std::vector<Parameter> parameters)
{
  Modifying modifying(modifying_);
  for (const auto & handle : living(pre_set_)) {
    handle->callback(parameters);
    if (parameters.empty()) {
      return refused(
        "parameter list is empty, most likely because pre-set callback rejected all parameters");
    }
  }
  Infos before;
  rcl_interfaces::msg::ParameterEvent event;
  for (const auto & parameter : parameters) {
    const auto & name = parameter.get_name();
    const auto found = parameters_.find(name);
    if (found == parameters_.end()) {
      if (!allow_undeclared_) {
        throw ParameterNotDeclaredException(
                "parameter '" + name + "' cannot be set because it was not declared");
      }
      before[name].descriptor.name = name;
      before[name].descriptor.dynamic_typing = true;
      continue;
    }
    if (found->second.descriptor.read_only) {
      return refused("parameter '" + name + "' cannot be set because it is read-only");
    }
    before.insert(*found);
  }
  auto after = before;
  const auto result = apply(parameters, after, true);
  if (!result.successful) {return result;}
  for (const auto & [name, info] : after) {
    const bool had_value = has_parameter(name) &&
      parameters_.at(name).value.get_type() != PARAMETER_NOT_SET;
    const auto message = Parameter(name, info.value).to_parameter_msg();
    if (info.value.get_type() == PARAMETER_NOT_SET) {
      // Setting a parameter to "not set" undeclares it.
      parameters_.erase(name);
      event.deleted_parameters.push_back(message);
      continue;
    }
    parameters_[name] = info;
    (had_value ? event.changed_parameters : event.new_parameters).push_back(message);
  }
  for (const auto & handle : living(post_set_)) {handle->callback(parameters);}
  publish_event(event);
  return result;
}

SetResult NodeParametersInterface::apply(
  const std::vector<Parameter> & parameters, Infos & infos, bool setting)
{
  for (const auto & parameter : parameters) {
    const auto & descriptor = infos[parameter.get_name()].descriptor;
    const bool deleting = setting && parameter.get_type() == PARAMETER_NOT_SET;
    if (deleting && descriptor.dynamic_typing) {continue;}
    const auto result = check(parameter.get_name(), parameter.get_parameter_value(), descriptor);
    if (!result.successful) {return result;}
  }
  for (const auto & handle : living(on_set_)) {
    const auto result = handle->callback(parameters);
    if (!result.successful) {return result;}
  }
  for (const auto & parameter : parameters) {
    auto & info = infos[parameter.get_name()];
    info.value = parameter.get_parameter_value();
    info.descriptor.type = info.value.get_type();
  }
  if (!setting) {
    for (const auto & handle : living(post_set_)) {handle->callback(parameters);}
  }
  return accepted();
}

void NodeParametersInterface::publish_event(rcl_interfaces::msg::ParameterEvent & event)
{
  if (!events_) {return;}
  event.node = node_->get_fully_qualified_name();
  event.stamp = Clock(RCL_ROS_TIME).now();
  events_->publish(event);
}

PreSetParametersCallbackHandle::SharedPtr
NodeParametersInterface::add_pre_set_parameters_callback(PreSetCallbackType callback)
{
  return add(pre_set_, std::move(callback));
}

OnSetParametersCallbackHandle::SharedPtr
NodeParametersInterface::add_on_set_parameters_callback(OnSetCallbackType callback)
{
  return add(on_set_, std::move(callback));
}

PostSetParametersCallbackHandle::SharedPtr
NodeParametersInterface::add_post_set_parameters_callback(PostSetCallbackType callback)
{
  return add(post_set_, std::move(callback));
}

void NodeParametersInterface::remove_pre_set_parameters_callback(
  const PreSetParametersCallbackHandle * handle)
{
  remove(pre_set_, handle);
}

void NodeParametersInterface::remove_on_set_parameters_callback(
  const OnSetParametersCallbackHandle * handle)
{
  remove(on_set_, handle);
}

void NodeParametersInterface::remove_post_set_parameters_callback(
  const PostSetParametersCallbackHandle * handle)
{
  remove(post_set_, handle);
}

NodeParametersInterface::SharedPtr NodeParametersInterface::linked(SharedPtr own) {return own;}

}  // namespace node_interfaces

node_interfaces::NodeParametersInterface::SharedPtr detail::make_node_parameters(
  const node_interfaces::NodeBaseInterface::SharedPtr & node, const NodeOptions & options,
  const Clock::SharedPtr & clock, TimeSource::SharedPtr & time_source)
{
  auto parameters = std::make_shared<node_interfaces::NodeParametersInterface>(node, options);
  if (clock->get_clock_type() == RCL_ROS_TIME) {
    time_source = std::make_shared<TimeSource>(options.clock_qos());
    time_source->attachNode(node, parameters);
    time_source->attachClock(clock);
  }
  return parameters;
}

}  // namespace rclcpp
