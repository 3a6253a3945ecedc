#include "rclcpp/parameter_event_handler.hpp"

#include <stdexcept>
#include <utility>

namespace rclcpp
{

ParameterEventHandler::ParameterEventHandler(
  node_interfaces::NodeBaseInterface::SharedPtr node, const QoS & qos)
: node_(std::move(node)),
  subscription_(
    std::make_shared<Subscription<Event>>(
      *node_, "/parameter_events", qos, [this](const Event & event) {handle(event);}))
{
  node_->add(detail::ExecutableKind::kSubscription, subscription_);
}

ParameterEventCallbackHandle::SharedPtr ParameterEventHandler::add_parameter_event_callback(
  ParameterEventCallbackType callback)
{
  auto handle = std::make_shared<ParameterEventCallbackHandle>();
  handle->callback = std::move(callback);
  of_events_.emplace_front(handle);
  return handle;
}

ParameterCallbackHandle::SharedPtr ParameterEventHandler::add_parameter_callback(
  const std::string & parameter_name, ParameterCallbackType callback,
  const std::string & node_name)
{
  auto handle = std::make_shared<ParameterCallbackHandle>();
  handle->parameter_name = parameter_name;
  handle->node_name = resolve(node_name);
  handle->callback = std::move(callback);
  of_parameters_.emplace_front(handle);
  return handle;
}

void ParameterEventHandler::remove_parameter_event_callback(
  ParameterEventCallbackHandle::SharedPtr handle)
{
  of_events_.remove_if([&handle](const auto & one) {return one.lock() == handle;});
}

void ParameterEventHandler::remove_parameter_callback(ParameterCallbackHandle::SharedPtr handle)
{
  of_parameters_.remove_if([&handle](const auto & one) {return one.lock() == handle;});
}

bool ParameterEventHandler::get_parameter_from_event(
  const Event & event, Parameter & parameter, const std::string & parameter_name,
  const std::string & node_name)
{
  if (!node_name.empty() && event.node != node_name) {return false;}
  for (const auto & one : get_parameters_from_event(event)) {
    if (one.get_name() == parameter_name) {
      parameter = one;
      return true;
    }
  }
  return false;
}

Parameter ParameterEventHandler::get_parameter_from_event(
  const Event & event, const std::string & parameter_name, const std::string & node_name)
{
  Parameter parameter;
  if (!get_parameter_from_event(event, parameter, parameter_name, node_name)) {
    throw std::runtime_error(
            "Parameter '" + parameter_name + "' of node '" + node_name +
            "' is not part of parameter event");
  }
  return parameter;
}

std::vector<Parameter> ParameterEventHandler::get_parameters_from_event(const Event & event)
{
  std::vector<Parameter> parameters;
  for (const auto * list : {&event.new_parameters, &event.changed_parameters}) {
    for (const auto & one : *list) {parameters.push_back(Parameter::from_parameter_msg(one));}
  }
  return parameters;
}

bool ParameterEventHandler::configure_nodes_filter(const std::vector<std::string> & node_names)
{
  nodes_.clear();
  for (const auto & name : node_names) {nodes_.insert(resolve(name));}
  return true;
}

std::string ParameterEventHandler::resolve(const std::string & node_name) const
{
  if (node_name.empty()) {return node_->get_fully_qualified_name();}
  if (node_name[0] == '/') {return node_name;}
  const std::string space = node_->get_namespace();
  return (space == "/" ? space : space + "/") + node_name;
}

void ParameterEventHandler::handle(const Event & event)
{
  if (!nodes_.empty() && nodes_.count(event.node) == 0) {return;}
  const auto of_parameters = of_parameters_;
  for (const auto & one : of_parameters) {
    const auto handle = one.lock();
    Parameter parameter;
    if (handle && get_parameter_from_event(
        event, parameter, handle->parameter_name, handle->node_name))
    {
      handle->callback(parameter);
    }
  }
  const auto of_events = of_events_;
  for (const auto & one : of_events) {
    if (const auto handle = one.lock()) {handle->callback(event);}
  }
}

}  // namespace rclcpp
