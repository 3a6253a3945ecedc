#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "rclcpp/any_subscription_callback.hpp"
#include "rclcpp/detail/receiver.hpp"
#include "rclcpp/event_handler.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{

struct SubscriptionOptions
{
  SubscriptionEventCallbacks event_callbacks;
  /// Log what is incompatible.
  bool use_default_callbacks = true;
  CallbackGroup::SharedPtr callback_group = nullptr;
};

class SubscriptionBase : public detail::Receiver
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(SubscriptionBase)

  SubscriptionBase(
    const node_interfaces::NodeBaseInterface & node, const std::string & topic,
    const detail::MessageMembers & type, const QoS & qos, const SubscriptionOptions & options);

  const char * get_topic_name() const {return name().c_str();}
  std::size_t get_publisher_count() const {return matched();}
  QoS get_actual_qos() const {return qos();}

  /// What calls back for its events.
  std::shared_ptr<detail::Executable> events() const {return events_;}

protected:
  const detail::MessageMembers & type_;

private:
  std::shared_ptr<detail::Events> events_;
};

template<class MessageT, class AllocatorT = std::allocator<void>>
class Subscription : public SubscriptionBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Subscription<MessageT, AllocatorT>)

  template<class CallbackT>
  Subscription(
    const node_interfaces::NodeBaseInterface & node, const std::string & topic, const QoS & qos,
    CallbackT && callback, const SubscriptionOptions & options = SubscriptionOptions())
  : SubscriptionBase(
      node, topic, rosidl_typesupport_sitegen_cpp::members_of<MessageT>(), qos, options),
    callback_(std::forward<CallbackT>(callback)) {}

protected:
  void handle(const SerializedMessage & bytes, rmw_message_info_t & info, double) override
  {
    if (callback_.wants_bytes()) {
      callback_.dispatch_bytes(std::make_shared<SerializedMessage>(bytes), MessageInfo(info));
      return;
    }
    auto message = std::make_shared<MessageT>();
    if (decode(type_, bytes, message.get())) {
      callback_.dispatch(std::move(message), MessageInfo(info));
    }
  }

private:
  AnySubscriptionCallback<MessageT> callback_;
};

}  // namespace rclcpp
