#pragma once

#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "rclcpp/generic_publisher.hpp"
#include "rclcpp/subscription.hpp"

namespace rclcpp
{

/// Passes serialized messages of a type known at run time to its callback.
class GenericSubscription : private detail::NamedType, public SubscriptionBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericSubscription)

  using Callback = AnySubscriptionCallback<SerializedMessage>;

  template<class CallbackT>
  GenericSubscription(
    const node_interfaces::NodeBaseInterface & node, const std::string & topic,
    const std::string & type, const QoS & qos, CallbackT && callback,
    const SubscriptionOptionsBase & options = SubscriptionOptions())
  : NamedType(type), SubscriptionBase(node, topic, members, qos, options),
    callback_(std::forward<CallbackT>(callback)) {}

  bool is_serialized() const override {return true;}
  std::shared_ptr<void> create_message() override {return std::make_shared<SerializedMessage>();}
  bool take_type_erased(void * message, MessageInfo & info) override
  {
    return take_serialized(*static_cast<SerializedMessage *>(message), info);
  }
  void handle_message(std::shared_ptr<void> & message, const MessageInfo & info) override
  {
    callback_.dispatch(std::static_pointer_cast<SerializedMessage>(message), info);
  }

protected:
  void handle(const SerializedMessage & bytes, rmw_message_info_t & info, double) override
  {
    arrived(info);
    callback_.dispatch(std::make_shared<SerializedMessage>(bytes), MessageInfo(info));
  }

private:
  Callback callback_;
};

}  // namespace rclcpp
