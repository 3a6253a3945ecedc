#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "rclcpp/detail/introspection.hpp"
#include "rclcpp/detail/pending_requests.hpp"
#include "rclcpp/detail/platform.hpp"
#include "rclcpp/detail/receiver.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{

namespace detail
{

/// A future with the number of its request; usable as a future.
template<class FutureT>
struct FutureAndRequestId
{
  FutureT future;
  std::int64_t request_id;

  FutureAndRequestId(FutureT that, std::int64_t id)
  : future(std::move(that)), request_id(id) {}

  operator FutureT &() {return future;}  // NOLINT: implicit upstream
  auto get() {return future.get();}
  bool valid() const noexcept {return future.valid();}
  void wait() const {future.wait();}
  template<class Rep, class Period>
  std::future_status wait_for(const std::chrono::duration<Rep, Period> & timeout) const
  {
    return future.wait_for(timeout);
  }
  template<class ClockT, class DurationT>
  std::future_status wait_until(const std::chrono::time_point<ClockT, DurationT> & until) const
  {
    return future.wait_until(until);
  }
};

}  // namespace detail

class ClientBase : public detail::Receiver
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(ClientBase)

  ClientBase(
    const node_interfaces::NodeBaseInterface & node, const std::string & name,
    const detail::MessageMembers & request, const QoS & qos);

  const char * get_service_name() const {return name().c_str();}
  bool service_is_ready() const {return matched() > 0;}
  QoS get_request_publisher_actual_qos() const {return qos();}
  QoS get_response_subscription_actual_qos() const {return qos();}
  virtual std::shared_ptr<void> create_response() const = 0;
  std::shared_ptr<rmw_request_id_t> create_request_header() const
  {
    return std::make_shared<rmw_request_id_t>();
  }
  /// Take the oldest response into a message of its type; false if there is none.
  bool take_type_erased_response(void * response, rmw_request_id_t & request_header);
  /// Wait until a server is available; false on timeout or shutdown.
  template<class Rep = std::int64_t, class Period = std::milli>
  bool wait_for_service(
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return wait(std::chrono::duration<double, std::milli>(timeout).count());
  }

protected:
  virtual const detail::MessageMembers & response_type() const = 0;
  std::int64_t send(const detail::MessageMembers & type, const void * request);
  /// The node of the client; throws RCLError if it has been destroyed.
  std::shared_ptr<const node_interfaces::NodeBaseInterface> node() const;

private:
  bool wait(double milliseconds);

  std::weak_ptr<const node_interfaces::NodeBaseInterface> node_;
};

template<class ServiceT>
class Client : public ClientBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Client<ServiceT>)

  using Request = typename ServiceT::Request;
  using Response = typename ServiceT::Response;
  using SharedRequest = std::shared_ptr<Request>;
  using SharedResponse = std::shared_ptr<Response>;
  using Promise = std::promise<SharedResponse>;
  using Future = std::future<SharedResponse>;
  using SharedFuture = std::shared_future<SharedResponse>;
  using PromiseWithRequest = std::promise<std::pair<SharedRequest, SharedResponse>>;
  using SharedFutureWithRequest = std::shared_future<std::pair<SharedRequest, SharedResponse>>;
  using CallbackType = std::function<void(SharedFuture)>;
  using CallbackWithRequestType = std::function<void(SharedFutureWithRequest)>;

  struct FutureAndRequestId : detail::FutureAndRequestId<Future>
  {
    using detail::FutureAndRequestId<Future>::FutureAndRequestId;

    SharedFuture share() noexcept {return this->future.share();}
    operator SharedFuture() {return share();}  // NOLINT: implicit upstream
  };
  using SharedFutureAndRequestId = detail::FutureAndRequestId<SharedFuture>;
  using SharedFutureWithRequestAndRequestId = detail::FutureAndRequestId<SharedFutureWithRequest>;

  Client(
    const node_interfaces::NodeBaseInterface & node, const std::string & name, const QoS & qos)
  : ClientBase(node, name, rosidl_typesupport_sitegen_cpp::members_of<Request>(), qos) {}

  std::shared_ptr<void> create_response() const override {return std::make_shared<Response>();}
  /// Take the oldest response; false if there is none.
  bool take_response(Response & response, rmw_request_id_t & request_header)
  {
    return take_type_erased_response(&response, request_header);
  }

  FutureAndRequestId async_send_request(SharedRequest request)
  {
    auto promise = std::make_shared<Promise>();
    auto future = promise->get_future();
    const auto id = begin(*request, [promise](SharedResponse response) {
          promise->set_value(std::move(response));
        });
    return FutureAndRequestId(std::move(future), id);
  }

  template<
    class CallbackT,
    std::enable_if_t<std::is_invocable_v<CallbackT &, SharedFuture>, int> = 0>
  SharedFutureAndRequestId async_send_request(SharedRequest request, CallbackT && callback)
  {
    auto promise = std::make_shared<Promise>();
    SharedFuture future = promise->get_future().share();
    const auto id = begin(
      *request,
      [promise, future, call = CallbackType(std::forward<CallbackT>(callback))](
        SharedResponse response) {
        promise->set_value(std::move(response));
        call(future);
      });
    return SharedFutureAndRequestId(std::move(future), id);
  }

  template<
    class CallbackT,
    std::enable_if_t<std::is_invocable_v<CallbackT &, SharedFutureWithRequest>, int> = 0>
  SharedFutureWithRequestAndRequestId async_send_request(
    SharedRequest request, CallbackT && callback)
  {
    auto promise = std::make_shared<PromiseWithRequest>();
    SharedFutureWithRequest future = promise->get_future().share();
    const auto id = begin(
      *request,
      [promise, future, request, call = CallbackWithRequestType(std::forward<CallbackT>(callback))](
        SharedResponse response) {
        promise->set_value({request, std::move(response)});
        call(future);
      });
    return SharedFutureWithRequestAndRequestId(std::move(future), id);
  }

  /// Remove a request: its future will never be ready. False if it was not pending.
  bool remove_pending_request(std::int64_t request_id) {return pending_.remove(request_id);}
  template<class FutureT>
  bool remove_pending_request(const detail::FutureAndRequestId<FutureT> & future)
  {
    return remove_pending_request(future.request_id);
  }
  /// Remove requests sent before `time_point`, and add their ids to `pruned_requests`.
  template<class AllocatorT = std::allocator<std::int64_t>>
  std::size_t prune_requests_older_than(
    std::chrono::time_point<std::chrono::system_clock> time_point,
    std::vector<std::int64_t, AllocatorT> * pruned_requests = nullptr)
  {
    return pending_.remove_older_than(time_point, pruned_requests);
  }
  std::size_t prune_pending_requests() {return pending_.clear();}

  /// Start or stop publishing requests and responses on `<service>/_service_event`.
  void configure_introspection(
    Clock::SharedPtr clock, const QoS & qos, rcl_service_introspection_state_t state)
  {
    introspection_.turn(*node(), get_service_name(), std::move(clock), qos, state);
  }

protected:
  void handle(const SerializedMessage & bytes, rmw_message_info_t & info, double) override
  {
    const auto id = static_cast<std::int64_t>(info.publication_sequence_number);
    if (!pending_.has(id)) {return;}  // removed, or answered by another server
    auto response = std::make_shared<Response>();
    if (!decode(response_type(), bytes, response.get())) {return;}
    introspection_.publish(
      detail::ServiceEvent::kResponseReceived, gid().data, id, nullptr, response.get());
    pending_.take(id)(std::move(response));
  }

  const detail::MessageMembers & response_type() const override
  {
    return rosidl_typesupport_sitegen_cpp::members_of<Response>();
  }

private:
  std::int64_t begin(
    const Request & request, typename detail::PendingRequests<Response>::Complete complete)
  {
    const auto id = send(rosidl_typesupport_sitegen_cpp::members_of<Request>(), &request);
    pending_.add(id, std::move(complete));
    introspection_.publish(
      detail::ServiceEvent::kRequestSent, gid().data, id, &request, nullptr);
    return id;
  }

  detail::PendingRequests<Response> pending_;
  detail::IntrospectionSwitch<ServiceT> introspection_;
};

}  // namespace rclcpp
