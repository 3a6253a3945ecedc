#pragma once

#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "rclcpp/detail/introspection.hpp"
#include "rclcpp/detail/receiver.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{

class ServiceBase : public detail::Receiver
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(ServiceBase)

  ServiceBase(
    const node_interfaces::NodeBaseInterface & node, const std::string & name,
    const detail::MessageMembers & request, const QoS & qos);

  const char * get_service_name() const {return name().c_str();}
  QoS get_request_subscription_actual_qos() const {return qos();}
  QoS get_response_publisher_actual_qos() const {return qos();}
  virtual std::shared_ptr<void> create_request() const = 0;
  std::shared_ptr<rmw_request_id_t> create_request_header() const
  {
    return std::make_shared<rmw_request_id_t>();
  }
  /// Take the oldest request into a message of its type; false if there is none.
  bool take_type_erased_request(void * request, rmw_request_id_t & request_id);

protected:
  virtual const detail::MessageMembers & request_type() const = 0;
  void respond(
    const rmw_request_id_t & to, const detail::MessageMembers & type, const void * response);
  static std::shared_ptr<rmw_request_id_t> request_id(
    const rmw_message_info_t & info, double writer_gid);
  /// The node of the service; throws RCLError if it has been destroyed.
  std::shared_ptr<const node_interfaces::NodeBaseInterface> node() const;

private:
  std::weak_ptr<const node_interfaces::NodeBaseInterface> node_;
};

namespace detail
{

template<class ServiceT, class RequestPtr>
using ServiceHandler =
  std::function<void (ServiceT &, std::shared_ptr<rmw_request_id_t>, RequestPtr)>;

template<class>
constexpr bool unsupported = false;

/// Any form of a service callback.
template<class ServiceT, class RequestPtr, class CallbackT>
ServiceHandler<ServiceT, RequestPtr> service_handler(CallbackT callback)
{
  using IdPtr = std::shared_ptr<rmw_request_id_t>;
  using ResponsePtr = decltype(std::declval<ServiceT &>().create_response());
  constexpr bool plain = std::is_invocable_v<CallbackT &, RequestPtr, ResponsePtr>;
  constexpr bool with_id = std::is_invocable_v<CallbackT &, IdPtr, RequestPtr, ResponsePtr>;
  if constexpr (plain || with_id) {
    return [callback](ServiceT & self, IdPtr id, RequestPtr request) mutable {
             auto response = self.create_response();
             if constexpr (with_id) {
               callback(id, std::move(request), response);
             } else {
               callback(std::move(request), response);
             }
             if constexpr (std::is_same_v<ResponsePtr, std::shared_ptr<void>>) {
               self.send_response(*id, response);
             } else {
               self.send_response(*id, *response);
             }
           };
  } else if constexpr (std::is_invocable_v<CallbackT &, IdPtr, RequestPtr>) {
    return [callback](ServiceT &, IdPtr id, RequestPtr request) mutable {
             callback(std::move(id), std::move(request));
           };
  } else if constexpr (
    std::is_invocable_v<CallbackT &, std::shared_ptr<ServiceT>, IdPtr, RequestPtr>)
  {
    return [callback](ServiceT & self, IdPtr id, RequestPtr request) mutable {
             callback(self.shared_from_this(), std::move(id), std::move(request));
           };
  } else {
    static_assert(
      unsupported<CallbackT>,
      "a service's callback takes (std::shared_ptr<Request>, std::shared_ptr<Response>), perhaps "
      "with a std::shared_ptr<rmw_request_id_t> before them, or answers later and takes "
      "(std::shared_ptr<rmw_request_id_t>, std::shared_ptr<Request>), perhaps with the service "
      "before them");
  }
}

}  // namespace detail

/// A service. A callback without a response parameter responds later, with send_response().
template<class ServiceT>
class Service : public ServiceBase, public std::enable_shared_from_this<Service<ServiceT>>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Service<ServiceT>)

  using Request = typename ServiceT::Request;
  using Response = typename ServiceT::Response;

  template<class CallbackT>
  Service(
    const node_interfaces::NodeBaseInterface & node, const std::string & name, const QoS & qos,
    CallbackT && callback)
  : ServiceBase(node, name, rosidl_typesupport_sitegen_cpp::members_of<Request>(), qos),
    callback_(
      detail::service_handler<Service, std::shared_ptr<Request>>(
        std::decay_t<CallbackT>(std::forward<CallbackT>(callback)))) {}

  std::shared_ptr<void> create_request() const override {return std::make_shared<Request>();}
  /// Take the oldest request; false if there is none.
  bool take_request(Request & request, rmw_request_id_t & request_id)
  {
    return take_type_erased_request(&request, request_id);
  }
  std::shared_ptr<Response> create_response() const {return std::make_shared<Response>();}
  void send_response(rmw_request_id_t & to, Response & response)
  {
    respond(to, rosidl_typesupport_sitegen_cpp::members_of<Response>(), &response);
    introspect(detail::ServiceEvent::kResponseSent, to, nullptr, &response);
  }
  /// Start or stop publishing requests and responses on `<service>/_service_event`.
  void configure_introspection(
    Clock::SharedPtr clock, const QoS & qos, rcl_service_introspection_state_t state)
  {
    introspection_.turn(*this->node(), get_service_name(), std::move(clock), qos, state);
  }

protected:
  void handle(
    const SerializedMessage & bytes, rmw_message_info_t & info, double writer_gid) override
  {
    auto request = std::make_shared<Request>();
    if (!decode(request_type(), bytes, request.get())) {return;}
    auto id = request_id(info, writer_gid);
    introspect(detail::ServiceEvent::kRequestReceived, *id, request.get(), nullptr);
    callback_(*this, std::move(id), std::move(request));
  }

  const detail::MessageMembers & request_type() const override
  {
    return rosidl_typesupport_sitegen_cpp::members_of<Request>();
  }

private:
  void introspect(
    detail::ServiceEvent what, const rmw_request_id_t & id, const Request * request,
    const Response * response)
  {
    const auto client = reinterpret_cast<const std::uint8_t *>(id.writer_guid);
    introspection_.publish(what, client, id.sequence_number, request, response);
  }

  detail::ServiceHandler<Service, std::shared_ptr<Request>> callback_;
  detail::IntrospectionSwitch<ServiceT> introspection_;
};

}  // namespace rclcpp
