#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>
#include <utility>

#include "rclcpp/any_subscription_callback.hpp"
#include "rclcpp/detail/receiver.hpp"
#include "rclcpp/event_handler.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/intra_process_buffer_type.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/subscription_content_filter_options.hpp"
#include "rclcpp/topic_statistics_state.hpp"

namespace rclcpp
{

struct SubscriptionOptionsBase
{
  SubscriptionEventCallbacks event_callbacks;
  /// Whether to log incompatible QoS.
  bool use_default_callbacks = true;
  bool ignore_local_publications = false;
  CallbackGroup::SharedPtr callback_group = nullptr;
  /// Whether it takes part in intra-process communication.
  IntraProcessSetting use_intra_process_comm = IntraProcessSetting::NodeDefault;
  /// Accepted and unused.
  IntraProcessBufferType intra_process_buffer_type = IntraProcessBufferType::CallbackDefault;
  rmw_unique_network_flow_endpoints_requirement_t require_unique_network_flow_endpoints =
    RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_NOT_REQUIRED;
  struct TopicStatisticsOptions
  {
    detail::TopicStatisticsSetting state = TopicStatisticsState::NodeDefault;
    std::string publish_topic = "/statistics";
    std::chrono::milliseconds publish_period{std::chrono::seconds(1)};
    QoS qos = SystemDefaultsQoS();
  } topic_stats_options;
  QosOverridingOptions qos_overriding_options;
  ContentFilterOptions content_filter_options;
};

/// The allocator is accepted and unused: messages use the standard allocator.
template<typename AllocatorT>
struct SubscriptionOptionsWithAllocator : SubscriptionOptionsBase
{
  std::shared_ptr<AllocatorT> allocator = nullptr;
};

using SubscriptionOptions = SubscriptionOptionsWithAllocator<std::allocator<void>>;

/// What a subscription passes to its callback.
enum class DeliveredMessageKind : std::uint8_t
{
  INVALID = 0,
  ROS_MESSAGE = 1,
  SERIALIZED_MESSAGE = 2,
  DYNAMIC_MESSAGE = 3,
};

class SubscriptionBase : public detail::Receiver
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(SubscriptionBase)

  SubscriptionBase(
    const node_interfaces::NodeBaseInterface & node, const std::string & topic,
    const detail::MessageMembers & type, const QoS & qos, const SubscriptionOptionsBase & options);
  ~SubscriptionBase() override;

  const char * get_topic_name() const {return name().c_str();}
  std::size_t get_publisher_count() const {return matched();}
  QoS get_actual_qos() const {return qos();}
  /// Whether a content filter is set.
  bool is_cft_enabled() const {return !filter_.filter_expression.empty();}
  /// Receive only messages that pass the filter, all if `expression` is empty. Throws RCLError if it is
  /// invalid.
  void set_content_filter(
    const std::string & expression, const std::vector<std::string> & parameters = {});
  /// Throws RCLError if none is set.
  ContentFilterOptions get_content_filter() const;
  std::vector<NetworkFlowEndpoint> get_network_flow_endpoints() const {return {};}
  bool can_loan_messages() const {return false;}
  virtual bool is_serialized() const = 0;
  DeliveredMessageKind get_delivered_message_kind() const
  {
    return is_serialized() ? DeliveredMessageKind::SERIALIZED_MESSAGE :
           DeliveredMessageKind::ROS_MESSAGE;
  }
  bool take_serialized(SerializedMessage & bytes, MessageInfo & info)
  {
    double writer_gid;
    return take_bytes(bytes, info.get_rmw_message_info(), writer_gid);
  }
  /// For callers that do not know the type.
  virtual std::shared_ptr<void> create_message() = 0;
  virtual bool take_type_erased(void * message, MessageInfo & info) = 0;
  virtual void handle_message(std::shared_ptr<void> & message, const MessageInfo & info) = 0;
  void return_message(std::shared_ptr<void> & message) {message.reset();}
  std::shared_ptr<SerializedMessage> create_serialized_message()
  {
    return std::make_shared<SerializedMessage>();
  }
  void return_serialized_message(std::shared_ptr<SerializedMessage> & message) {message.reset();}

  /// The waitable that runs the event callbacks.
  std::shared_ptr<Waitable> events() const {return events_;}
  /// Apply the setting of the node where the options leave it to the node.
  void set_node_default(bool intra_process)
  {
    if (intra_process_ == IntraProcessSetting::NodeDefault) {share(intra_process);}
  }
  void observe(detail::Arrival arrival) {arrival_ = std::move(arrival);}

protected:
  void arrived(const rmw_message_info_t & info)
  {
    if (arrival_) {arrival_(info);}
  }

  /// Whether intra-process communication is enabled.
  bool shares() const {return shares_;}

  const detail::MessageMembers & type_;

private:
  void share(bool shares);
  /// Set the filter; throws RCLError with `what` and the reason.
  void filter(const ContentFilterOptions & options, const std::string & what);

  ContentFilterOptions filter_;
  detail::Arrival arrival_;
  std::shared_ptr<detail::Events> events_;
  IntraProcessSetting intra_process_;
  bool shares_ = false;
};

template<class MessageT, class AllocatorT = std::allocator<void>>
class Subscription : public SubscriptionBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Subscription<MessageT, AllocatorT>)

  /// The type of the callback, and the type received; they differ with a TypeAdapter.
  using SubscribedType = detail::custom_type<MessageT>;
  using ROSMessageType = detail::ros_type<MessageT>;

  template<class CallbackT>
  Subscription(
    const node_interfaces::NodeBaseInterface & node, const std::string & topic, const QoS & qos,
    CallbackT && callback, const SubscriptionOptionsBase & options = SubscriptionOptions())
  : SubscriptionBase(
      node, topic, rosidl_typesupport_sitegen_cpp::members_of<ROSMessageType>(), qos, options),
    callback_(std::forward<CallbackT>(callback)) {}

  bool is_serialized() const override {return callback_.wants_bytes();}
  /// Take the oldest message; false if there is none.
  bool take(ROSMessageType & message, MessageInfo & info)
  {
    return take_type_erased(&message, info);
  }
  std::shared_ptr<void> create_message() override {return std::make_shared<ROSMessageType>();}
  bool take_type_erased(void * message, MessageInfo & info) override
  {
    SerializedMessage bytes;
    return take_serialized(bytes, info) && decode(type_, bytes, message);
  }
  void handle_message(std::shared_ptr<void> & message, const MessageInfo & info) override
  {
    dispatch(std::static_pointer_cast<ROSMessageType>(message), info);
  }

protected:
  void handle(const SerializedMessage & bytes, rmw_message_info_t & info, double writer_gid) override
  {
    arrived(info);
    if (callback_.wants_bytes()) {
      callback_.dispatch_bytes(std::make_shared<SerializedMessage>(bytes), MessageInfo(info));
      return;
    }
    if constexpr (!detail::is_adapted<MessageT>) {
      if (shares() && take_shared(writer_gid, info)) {return;}
    }
    auto message = std::make_shared<ROSMessageType>();
    if (decode(type_, bytes, message.get())) {dispatch(std::move(message), MessageInfo(info));}
  }

private:
  /// Run the callback with the shared message of `writer_gid`; false if there is none.
  bool take_shared(double writer_gid, const rmw_message_info_t & info)
  {
    namespace shared = detail::intra_process;
    const auto found = std::static_pointer_cast<shared::TypedMessage<ROSMessageType>>(
      shared::take(writer_gid, info.publication_sequence_number));
    if (!found) {return false;}
    MessageInfo told(info);
    told.get_rmw_message_info().from_intra_process = true;
    if (!callback_.owns()) {
      callback_.dispatch(
        std::shared_ptr<ROSMessageType>(found, const_cast<ROSMessageType *>(&found->get())), told);
    } else if (found->left || found.use_count() > 1) {
      callback_.dispatch_unique(std::make_unique<ROSMessageType>(found->get()), told);
    } else {
      callback_.dispatch_unique(found->take(), told);
    }
    return true;
  }

  void dispatch(std::shared_ptr<ROSMessageType> message, const MessageInfo & info)
  {
    if constexpr (detail::is_adapted<MessageT>) {
      auto custom = std::make_shared<SubscribedType>();
      detail::Adapter<MessageT>::convert_to_custom(*message, *custom);
      callback_.dispatch(std::move(custom), info);
    } else {
      callback_.dispatch(std::move(message), info);
    }
  }

  AnySubscriptionCallback<SubscribedType> callback_;
};

}  // namespace rclcpp
