// Services and clients whose types are known by name. In a file of its own, so that programs without
// them do not link a list of types.
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "rclcpp/generic_client.hpp"
#include "rclcpp/generic_service.hpp"

namespace rclcpp
{

namespace detail
{

namespace
{

std::map<std::string, NamedService> & known()
{
  static std::map<std::string, NamedService> known;
  return known;
}

}  // namespace

const NamedService & named_service(const std::string & name)
{
  const auto found = known().find(name);
  if (found == known().end()) {
    throw std::runtime_error(
            "the service type '" + name + "' is not known here: include its header");
  }
  return found->second;
}

}  // namespace detail

GenericClient::GenericClient(
  const node_interfaces::NodeBaseInterface & node, const std::string & name,
  const std::string & type, const QoS & qos)
: ClientBase(node, name, *detail::named_service(type).request, qos),
  type_(detail::named_service(type))
{
}

GenericClient::FutureAndRequestId GenericClient::async_send_request(const Request request)
{
  auto promise = std::make_shared<Promise>();
  auto future = promise->get_future();
  const auto id = send(*type_.request, request);
  pending_.add(id, [promise](SharedResponse response) {promise->set_value(std::move(response));});
  return FutureAndRequestId(std::move(future), id);
}

GenericClient::SharedFutureAndRequestId GenericClient::begin(
  const void * request, CallbackType callback)
{
  auto promise = std::make_shared<Promise>();
  SharedFuture future = promise->get_future().share();
  const auto id = send(*type_.request, request);
  pending_.add(
    id, [promise, future, callback = std::move(callback)](SharedResponse response) {
      promise->set_value(std::move(response));
      callback(future);
    });
  return SharedFutureAndRequestId(std::move(future), id);
}

GenericClient::SharedResponse GenericClient::create_response() const
{
  return detail::make_message(*type_.response);
}

void GenericClient::handle(const SerializedMessage & bytes, rmw_message_info_t & info, double)
{
  const auto id = static_cast<std::int64_t>(info.publication_sequence_number);
  auto response = create_response();
  if (!pending_.has(id) || !decode(*type_.response, bytes, response.get())) {return;}
  pending_.take(id)(std::move(response));
}

void GenericService::handle(
  const SerializedMessage & bytes, rmw_message_info_t & info, double writer_gid)
{
  auto request = create_request();
  if (!decode(*type_.request, bytes, request.get())) {return;}
  callback_(*this, request_id(info, writer_gid), std::move(request));
}

}  // namespace rclcpp

namespace rosidl_typesupport_sitegen_cpp
{

void note_service(const MessageMembers & request, const MessageMembers & response)
{
  rclcpp::detail::known()[rclcpp::detail::service_type(request)] = {&request, &response};
}

}  // namespace rosidl_typesupport_sitegen_cpp
