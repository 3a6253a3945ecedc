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

#include "rclcpp/client.hpp"
#include "rclcpp/detail/named_service.hpp"

namespace rclcpp
{

/// A client of a service whose type is known at run time. Requests and responses are messages
/// of that type.
class GenericClient : public ClientBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericClient)

  using Request = void *;
  using Response = void *;
  using SharedResponse = std::shared_ptr<void>;
  using Promise = std::promise<SharedResponse>;
  using SharedPromise = std::shared_ptr<Promise>;
  using Future = std::future<SharedResponse>;
  using SharedFuture = std::shared_future<SharedResponse>;
  using CallbackType = std::function<void (SharedFuture)>;

  struct FutureAndRequestId : detail::FutureAndRequestId<Future>
  {
    using detail::FutureAndRequestId<Future>::FutureAndRequestId;

    SharedFuture share() noexcept {return this->future.share();}
  };
  using SharedFutureAndRequestId = detail::FutureAndRequestId<SharedFuture>;

  /// Throws std::runtime_error if the program does not include the header of the type.
  GenericClient(
    const node_interfaces::NodeBaseInterface & node, const std::string & name,
    const std::string & type, const QoS & qos);

  FutureAndRequestId async_send_request(const Request request);

  template<
    class CallbackT,
    std::enable_if_t<std::is_invocable_v<CallbackT &, SharedFuture>, int> = 0>
  SharedFutureAndRequestId async_send_request(const Request request, CallbackT && callback)
  {
    return begin(request, CallbackType(std::forward<CallbackT>(callback)));
  }

  SharedResponse create_response() const override;
  /// Take the oldest response into a message of its type; false if there is none.
  bool take_response(Response response, rmw_request_id_t & request_header)
  {
    return take_type_erased_response(response, request_header);
  }
  bool remove_pending_request(std::int64_t request_id) {return pending_.remove(request_id);}
  template<class FutureT>
  bool remove_pending_request(const detail::FutureAndRequestId<FutureT> & future)
  {
    return remove_pending_request(future.request_id);
  }
  template<class AllocatorT = std::allocator<std::int64_t>>
  std::size_t prune_requests_older_than(
    std::chrono::time_point<std::chrono::system_clock> time_point,
    std::vector<std::int64_t, AllocatorT> * pruned_requests = nullptr)
  {
    return pending_.remove_older_than(time_point, pruned_requests);
  }
  std::size_t prune_pending_requests() {return pending_.clear();}

protected:
  void handle(const SerializedMessage & bytes, rmw_message_info_t & info, double) override;
  const detail::MessageMembers & response_type() const override {return *type_.response;}

private:
  SharedFutureAndRequestId begin(const void * request, CallbackType callback);

  const detail::NamedService & type_;
  detail::PendingRequests<void> pending_;
};

}  // namespace rclcpp
