#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "rclcpp/detail/named_service.hpp"
#include "rclcpp/service.hpp"

namespace rclcpp
{

/// A service whose type is known at run time. Its callback takes messages of that type, in the
/// same forms as other services.
class GenericService : public ServiceBase, public std::enable_shared_from_this<GenericService>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericService)

  using Request = void *;
  using Response = void *;
  using SharedRequest = std::shared_ptr<void>;
  using SharedResponse = std::shared_ptr<void>;
  using CallbackType = std::function<void (const SharedRequest, SharedResponse)>;
  using CallbackWithHeaderType = std::function<
    void (const std::shared_ptr<rmw_request_id_t>, const SharedRequest, SharedResponse)>;

  /// Throws std::runtime_error if the program does not include the header of the type.
  template<class CallbackT>
  GenericService(
    const node_interfaces::NodeBaseInterface & node, const std::string & name,
    const std::string & type, const QoS & qos, CallbackT && callback)
  : ServiceBase(node, name, *detail::named_service(type).request, qos),
    type_(detail::named_service(type)),
    callback_(
      detail::service_handler<GenericService, SharedRequest>(
        std::decay_t<CallbackT>(std::forward<CallbackT>(callback)))) {}

  SharedRequest create_request() const override {return detail::make_message(*type_.request);}
  /// Take the oldest request into a message of its type; false if there is none.
  bool take_request(Request request, rmw_request_id_t & request_id)
  {
    return take_type_erased_request(request, request_id);
  }
  SharedResponse create_response() const {return detail::make_message(*type_.response);}
  void send_response(rmw_request_id_t & to, SharedResponse & response)
  {
    respond(to, *type_.response, response.get());
  }

protected:
  void handle(const SerializedMessage & bytes, rmw_message_info_t & info, double writer_gid) override;
  const detail::MessageMembers & request_type() const override {return *type_.request;}

private:
  const detail::NamedService & type_;
  detail::ServiceHandler<GenericService, SharedRequest> callback_;
};

}  // namespace rclcpp
