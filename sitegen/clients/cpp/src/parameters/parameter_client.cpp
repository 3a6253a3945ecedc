#include "rclcpp/parameter_client.hpp"

#include <algorithm>

namespace rclcpp
{

namespace srv = rcl_interfaces::srv;

namespace
{

/// Send `request` and return a future of the result of `read` for the response.
template<class ResultT, class ServiceT, class ReadT>
std::shared_future<ResultT> ask(
  Client<ServiceT> & client, std::shared_ptr<typename ServiceT::Request> request, ReadT read,
  std::function<void (std::shared_future<ResultT>)> callback)
{
  auto promise = std::make_shared<std::promise<ResultT>>();
  auto future = promise->get_future().share();
  client.async_send_request(
    request, [promise, future, read, callback](typename Client<ServiceT>::SharedFuture answer) {
      promise->set_value(read(*answer.get()));
      if (callback) {callback(future);}
    });
  return future;
}

}  // namespace

template<class ServiceT>
std::shared_ptr<Client<ServiceT>> AsyncParametersClient::make(
  const std::string & remote, const char * name, const QoS & qos,
  const CallbackGroup::SharedPtr & group)
{
  auto client = std::make_shared<Client<ServiceT>>(*node_, remote + "/" + name, qos);
  node_->add(detail::ExecutableKind::kClient, client, group);
  clients_.push_back(client);
  return client;
}

AsyncParametersClient::AsyncParametersClient(
  node_interfaces::NodeBaseInterface::SharedPtr node, const std::string & remote,
  const QoS & qos, CallbackGroup::SharedPtr group)
: node_(std::move(node)), remote_(remote.empty() ? node_->get_fully_qualified_name() : remote)
{
  get_ = make<srv::GetParameters>(remote_, "get_parameters", qos, group);
  types_ = make<srv::GetParameterTypes>(remote_, "get_parameter_types", qos, group);
  set_ = make<srv::SetParameters>(remote_, "set_parameters", qos, group);
  set_atomically_ =
    make<srv::SetParametersAtomically>(remote_, "set_parameters_atomically", qos, group);
  list_ = make<srv::ListParameters>(remote_, "list_parameters", qos, group);
  describe_ = make<srv::DescribeParameters>(remote_, "describe_parameters", qos, group);
}

std::shared_future<std::vector<Parameter>> AsyncParametersClient::get_parameters(
  const std::vector<std::string> & names, Callback<std::vector<Parameter>> callback)
{
  auto request = std::make_shared<srv::GetParameters::Request>();
  request->names = names;
  return ask<std::vector<Parameter>>(
    *get_, request, [names](const auto & response) {
      std::vector<Parameter> parameters;
      for (std::size_t i = 0; i < std::min(names.size(), response.values.size()); ++i) {
        parameters.emplace_back(names[i], ParameterValue(response.values[i]));
      }
      return parameters;
    }, callback);
}

std::shared_future<std::vector<rcl_interfaces::msg::ParameterDescriptor>>
AsyncParametersClient::describe_parameters(
  const std::vector<std::string> & names,
  Callback<std::vector<rcl_interfaces::msg::ParameterDescriptor>> callback)
{
  auto request = std::make_shared<srv::DescribeParameters::Request>();
  request->names = names;
  return ask<std::vector<rcl_interfaces::msg::ParameterDescriptor>>(
    *describe_, request, [](const auto & response) {return response.descriptors;}, callback);
}

std::shared_future<std::vector<ParameterType>> AsyncParametersClient::get_parameter_types(
  const std::vector<std::string> & names, Callback<std::vector<ParameterType>> callback)
{
  auto request = std::make_shared<srv::GetParameterTypes::Request>();
  request->names = names;
  return ask<std::vector<ParameterType>>(
    *types_, request, [](const auto & response) {
      std::vector<ParameterType> types;
      for (const auto type : response.types) {types.push_back(static_cast<ParameterType>(type));}
      return types;
    }, callback);
}

std::shared_future<std::vector<AsyncParametersClient::SetResult>>
AsyncParametersClient::set_parameters(
  const std::vector<Parameter> & parameters, Callback<std::vector<SetResult>> callback)
{
  auto request = std::make_shared<srv::SetParameters::Request>();
  for (const auto & parameter : parameters) {
    request->parameters.push_back(parameter.to_parameter_msg());
  }
  return ask<std::vector<SetResult>>(
    *set_, request, [](const auto & response) {return response.results;}, callback);
}

std::shared_future<AsyncParametersClient::SetResult>
AsyncParametersClient::set_parameters_atomically(
  const std::vector<Parameter> & parameters, Callback<SetResult> callback)
{
  auto request = std::make_shared<srv::SetParametersAtomically::Request>();
  for (const auto & parameter : parameters) {
    request->parameters.push_back(parameter.to_parameter_msg());
  }
  return ask<SetResult>(
    *set_atomically_, request, [](const auto & response) {return response.result;}, callback);
}

std::shared_future<std::vector<AsyncParametersClient::SetResult>>
AsyncParametersClient::delete_parameters(const std::vector<std::string> & names)
{
  std::vector<Parameter> parameters;
  for (const auto & name : names) {parameters.emplace_back(name);}
  return set_parameters(parameters);
}

std::shared_future<std::vector<AsyncParametersClient::SetResult>>
AsyncParametersClient::load_parameters(const std::string & yaml_filename)
{
  return load_parameters(parameter_map_from_yaml_file(yaml_filename, remote_.c_str()));
}

std::shared_future<std::vector<AsyncParametersClient::SetResult>>
AsyncParametersClient::load_parameters(const ParameterMap & parameter_map)
{
  const auto parameters = parameters_from_map(parameter_map, remote_.c_str());
  if (parameters.empty()) {
    throw exceptions::InvalidParametersException("No valid parameter");
  }
  return set_parameters(parameters);
}

std::shared_future<rcl_interfaces::msg::ListParametersResult>
AsyncParametersClient::list_parameters(
  const std::vector<std::string> & prefixes, std::uint64_t depth,
  Callback<rcl_interfaces::msg::ListParametersResult> callback)
{
  auto request = std::make_shared<srv::ListParameters::Request>();
  request->prefixes = prefixes;
  request->depth = depth;
  return ask<rcl_interfaces::msg::ListParametersResult>(
    *list_, request, [](const auto & response) {return response.result;}, callback);
}

bool AsyncParametersClient::service_is_ready() const
{
  return std::all_of(clients_.begin(), clients_.end(), [](const auto & client) {
             return client->service_is_ready();
           });
}

}  // namespace rclcpp
