// Service introspection: the events that a service or a client publishes about its calls.
#pragma once

#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

#include "rcl/service_introspection.h"
#include "rclcpp/clock.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/qos.hpp"

namespace rclcpp
{
namespace detail
{

/// The event types of service_msgs/msg/ServiceEventInfo.
enum class ServiceEvent : std::uint8_t
{
  kRequestSent = 0, kRequestReceived = 1, kResponseSent = 2, kResponseReceived = 3
};

template<class ServiceT>
class Introspection
{
public:
  using Request = typename ServiceT::Request;
  using Response = typename ServiceT::Response;

  /// `node` is the node of the service or client `name`.
  Introspection(
    const node_interfaces::NodeBaseInterface & node, const std::string & name,
    Clock::SharedPtr clock, const QoS & qos, rcl_service_introspection_state_t state)
  : clock_(std::move(clock)), contents_(state == RCL_SERVICE_INTROSPECTION_CONTENTS),
    publisher_(node, name + RCL_SERVICE_INTROSPECTION_TOPIC_POSTFIX, qos) {}

  /// `client` is the gid of the client; one of `request` and `response` is null.
  void publish(
    ServiceEvent what, const std::uint8_t * client, std::int64_t sequence,
    const Request * request, const Response * response)
  {
    typename ServiceT::Event event;
    event.info.event_type = static_cast<std::uint8_t>(what);
    event.info.stamp = clock_->now();
    std::memcpy(event.info.client_gid.data(), client, event.info.client_gid.size());
    event.info.sequence_number = sequence;
    if (contents_ && request) {event.request.push_back(*request);}
    if (contents_ && response) {event.response.push_back(*response);}
    publisher_.publish(event);
  }

private:
  Clock::SharedPtr clock_;
  bool contents_;
  Publisher<typename ServiceT::Event> publisher_;
};

/// Introspection that may be disabled. The publisher is linked only into programs that enable it.
template<class ServiceT>
class IntrospectionSwitch
{
public:
  using Publish = void (*)(
    void * to, ServiceEvent what, const std::uint8_t * client, std::int64_t sequence,
    const typename ServiceT::Request * request, const typename ServiceT::Response * response);

  void turn(
    const node_interfaces::NodeBaseInterface & node, const std::string & name,
    Clock::SharedPtr clock, const QoS & qos, rcl_service_introspection_state_t state)
  {
    publish_ = nullptr;
    to_.reset();
    if (state == RCL_SERVICE_INTROSPECTION_OFF) {return;}
    to_ = std::make_shared<Introspection<ServiceT>>(node, name, std::move(clock), qos, state);
    publish_ = [](void * to, auto ... what) {
        static_cast<Introspection<ServiceT> *>(to)->publish(what ...);
      };
  }

  void publish(
    ServiceEvent what, const std::uint8_t * client, std::int64_t sequence,
    const typename ServiceT::Request * request, const typename ServiceT::Response * response)
  {
    if (publish_) {publish_(to_.get(), what, client, sequence, request, response);}
  }

private:
  Publish publish_ = nullptr;
  std::shared_ptr<void> to_;
};

}  // namespace detail
}  // namespace rclcpp
