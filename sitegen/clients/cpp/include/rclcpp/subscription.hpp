#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "rclcpp/any_subscription_callback.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/qos.hpp"
#include "rosidl_typesupport_sitegen_cpp/message_type_support.hpp"

namespace rclcpp
{

struct SubscriptionOptions {};

class SubscriptionBase
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(SubscriptionBase)
  RCLCPP_DISABLE_COPY(SubscriptionBase)

  SubscriptionBase(
    const node_interfaces::NodeBaseInterface & node, const std::string & topic,
    const rosidl_typesupport_sitegen_cpp::MessageMembers & type, const QoS & qos);
  virtual ~SubscriptionBase();

  const char * get_topic_name() const {return topic_.c_str();}
  std::size_t get_publisher_count() const;
  QoS get_actual_qos() const {return qos_;}

  /// Call back with the oldest message that waits; false if none did.
  bool execute_one();

protected:
  /// Read `bytes` into `message`; when they are of another type, log an error and return false.
  bool decode(const SerializedMessage & bytes, void * message) const;
  virtual void handle(SerializedMessage && bytes, const MessageInfo & info) = 0;

private:
  const rosidl_typesupport_sitegen_cpp::MessageMembers & type_;
  std::string topic_;
  QoS qos_;
  std::int32_t id_;
  std::uint64_t received_ = 0;
};

template<class MessageT, class AllocatorT = std::allocator<void>>
class Subscription : public SubscriptionBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Subscription<MessageT, AllocatorT>)

  template<class CallbackT>
  Subscription(
    const node_interfaces::NodeBaseInterface & node, const std::string & topic, const QoS & qos,
    CallbackT && callback)
  : SubscriptionBase(
      node, topic, rosidl_typesupport_sitegen_cpp::members_of<MessageT>(), qos),
    callback_(std::forward<CallbackT>(callback)) {}

protected:
  void handle(SerializedMessage && bytes, const MessageInfo & info) override
  {
    if (callback_.wants_bytes()) {
      callback_.dispatch_bytes(std::make_shared<SerializedMessage>(std::move(bytes)), info);
      return;
    }
    auto message = std::make_shared<MessageT>();
    if (decode(bytes, message.get())) {callback_.dispatch(std::move(message), info);}
  }

private:
  AnySubscriptionCallback<MessageT> callback_;
};

}  // namespace rclcpp
