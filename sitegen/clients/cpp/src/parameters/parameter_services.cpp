#include "rclcpp/detail/parameter_services.hpp"

#include <string>

#include "rcl_interfaces/srv/describe_parameters.hpp"
#include "rcl_interfaces/srv/get_parameter_types.hpp"
#include "rcl_interfaces/srv/get_parameters.hpp"
#include "rcl_interfaces/srv/list_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters_atomically.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"

namespace rclcpp
{
namespace detail
{

namespace
{

namespace srv = rcl_interfaces::srv;

std::vector<Parameter> read(const std::vector<rcl_interfaces::msg::Parameter> & messages)
{
  std::vector<Parameter> parameters;
  for (const auto & message : messages) {
    parameters.push_back(Parameter::from_parameter_msg(message));
  }
  return parameters;
}

/// Call `act`; if it throws, log the exception and return its text.
template<class ActT>
std::string attempt(const char * what, ActT act)
{
  try {
    act();
    return "";
  } catch (const std::runtime_error & error) {
    RCLCPP_DEBUG(Logger("rclcpp"), "Failed to %s parameters: %s", what, error.what());
    return error.what();
  }
}

}  // namespace

ParameterServices::ParameterServices(
  node_interfaces::NodeBaseInterface & node,
  node_interfaces::NodeParametersInterface & parameters, const QoS & qos)
{
  const auto serve = [&](auto type, const char * name, auto callback) {
      using ServiceT = decltype(type);
      auto service = std::make_shared<Service<ServiceT>>(
        node, std::string("~/") + name, qos,
        [callback](
          std::shared_ptr<typename ServiceT::Request> request,
          std::shared_ptr<typename ServiceT::Response> response) {
          callback(*request, *response);
        });
      node.add(ExecutableKind::kService, service);
      services_.push_back(service);
    };
  serve(
    srv::GetParameters(), "get_parameters", [&parameters](const auto & request, auto & response) {
      attempt("get", [&] {
        for (const auto & parameter : parameters.get_parameters(request.names)) {
          response.values.push_back(parameter.get_value_message());
        }
      });
    });
  serve(
    srv::GetParameterTypes(), "get_parameter_types",
    [&parameters](const auto & request, auto & response) {
      attempt("get the types of", [&] {
        response.types = parameters.get_parameter_types(request.names);
      });
    });
  serve(
    srv::SetParameters(), "set_parameters", [&parameters](const auto & request, auto & response) {
      for (const auto & parameter : read(request.parameters)) {
        rcl_interfaces::msg::SetParametersResult result;
        const auto reason = attempt("set", [&] {
          result = parameters.set_parameters_atomically({parameter});
        });
        if (!reason.empty()) {result.reason = reason;}
        response.results.push_back(result);
      }
    });
  serve(
    srv::SetParametersAtomically(), "set_parameters_atomically",
    [&parameters](const auto & request, auto & response) {
      const auto reason = attempt("set", [&] {
        response.result = parameters.set_parameters_atomically(read(request.parameters));
      });
      if (!reason.empty()) {response.result.reason = "One or more parameters were not declared before setting";}
    });
  serve(
    srv::DescribeParameters(), "describe_parameters",
    [&parameters](const auto & request, auto & response) {
      attempt("describe", [&] {
        response.descriptors = parameters.describe_parameters(request.names);
      });
    });
  serve(
    srv::ListParameters(), "list_parameters", [&parameters](const auto & request, auto & response) {
      response.result = parameters.list_parameters(request.prefixes, request.depth);
    });
}

}  // namespace detail
}  // namespace rclcpp
