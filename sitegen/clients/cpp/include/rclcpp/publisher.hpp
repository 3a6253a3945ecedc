#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "rclcpp/detail/intra_process.hpp"
#include "rclcpp/detail/receiver.hpp"
#include "rclcpp/event_handler.hpp"
#include "rclcpp/loaned_message.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/network_flow_endpoint.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/qos_overriding_options.hpp"
#include "rclcpp/serialized_message.hpp"
#include "rclcpp/type_adapter.hpp"

enum rmw_unique_network_flow_endpoints_requirement_t
{
  RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_NOT_REQUIRED,
  RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_STRICTLY_REQUIRED,
  RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_OPTIONALLY_REQUIRED,
  RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_SYSTEM_DEFAULT
};

namespace rclcpp
{

enum class IntraProcessSetting {Enable, Disable, NodeDefault};

struct PublisherOptionsBase
{
  PublisherEventCallbacks event_callbacks;
  /// Whether to log incompatible QoS.
  bool use_default_callbacks = true;
  CallbackGroup::SharedPtr callback_group = nullptr;
  /// Whether subscriptions of this program receive messages published as std::unique_ptr without
  /// copying.
  IntraProcessSetting use_intra_process_comm = IntraProcessSetting::NodeDefault;
  rmw_unique_network_flow_endpoints_requirement_t require_unique_network_flow_endpoints =
    RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_NOT_REQUIRED;
  QosOverridingOptions qos_overriding_options;
};

/// The allocator is accepted and unused: messages use the standard allocator.
template<typename AllocatorT>
struct PublisherOptionsWithAllocator : PublisherOptionsBase
{
  std::shared_ptr<AllocatorT> allocator = nullptr;
};

using PublisherOptions = PublisherOptionsWithAllocator<std::allocator<void>>;

class PublisherBase
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(PublisherBase)

  PublisherBase(
    const node_interfaces::NodeBaseInterface & node, const std::string & topic,
    const detail::MessageMembers & type, const QoS & qos, const PublisherOptionsBase & options);
  virtual ~PublisherBase() = default;

  const char * get_topic_name() const {return endpoint_.name().c_str();}
  std::size_t get_queue_size() const {return endpoint_.qos().depth();}
  std::size_t get_subscription_count() const {return endpoint_.matched();}
  std::size_t get_intra_process_subscription_count() const
  {
    return shares_ ? detail::intra_process::subscriptions(endpoint_.name()) : 0;
  }
  QoS get_actual_qos() const {return endpoint_.qos();}
  bool is_durability_transient_local() const
  {
    return endpoint_.qos().durability() == DurabilityPolicy::TransientLocal;
  }
  rmw_gid_t get_gid() const {return endpoint_.gid();}
  bool can_loan_messages() const {return false;}
  /// There is no network, so the list is empty.
  std::vector<NetworkFlowEndpoint> get_network_flow_endpoints() const {return {};}
  /// Assert liveliness, for manual liveliness.
  bool assert_liveliness() const;
  /// Wait until all reliable subscriptions have received all messages; false after `timeout`, which is
  /// unlimited if negative.
  template<class Rep = std::int64_t, class Period = std::milli>
  bool wait_for_all_acked(
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1)) const
  {
    return wait_until_sent(std::chrono::duration<double, std::milli>(timeout).count());
  }

  /// The waitable that runs the event callbacks.
  std::shared_ptr<Waitable> events() const {return events_;}
  /// Apply the setting of the node where the options leave it to the node.
  void set_node_default(bool intra_process)
  {
    if (intra_process_ == IntraProcessSetting::NodeDefault) {shares_ = intra_process;}
  }

protected:
  void publish_message(const void * message);
  /// Share the last message published with the intra-process subscriptions.
  void share(std::shared_ptr<detail::intra_process::Message> message);
  void publish_bytes(const SerializedMessage & bytes);

private:
  /// Send a message; with history KEEP_ALL, wait for full queues. Throws RCLError on timeout.
  void send(const std::uint8_t * data, std::uint32_t size);
  bool wait_until_sent(double milliseconds) const;

  const detail::MessageMembers & type_;
  detail::Endpoint endpoint_;
  std::shared_ptr<detail::Events> events_;
  IntraProcessSetting intra_process_;
  bool shares_;
  std::uint64_t sent_ = 0;
  std::shared_ptr<void> shared_;  // drops shared messages on destruction
};

template<class MessageT, class AllocatorT = std::allocator<void>>
class Publisher : public PublisherBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Publisher<MessageT, AllocatorT>)

  /// The type published, and the type sent; they differ with a TypeAdapter.
  using PublishedType = detail::custom_type<MessageT>;
  using ROSMessageType = detail::ros_type<MessageT>;

  Publisher(
    const node_interfaces::NodeBaseInterface & node, const std::string & topic, const QoS & qos,
    const PublisherOptionsBase & options = PublisherOptions())
  : PublisherBase(
      node, topic, rosidl_typesupport_sitegen_cpp::members_of<ROSMessageType>(), qos, options) {}

  void publish(const PublishedType & message)
  {
    if constexpr (detail::is_adapted<MessageT>) {
      ROSMessageType converted;
      detail::Adapter<MessageT>::convert_to_ros_message(message, converted);
      publish_message(&converted);
    } else {
      publish_message(&message);
    }
  }
  template<class DeleterT>
  void publish(std::unique_ptr<PublishedType, DeleterT> message)
  {
    publish(*message);
    // A message with a custom deleter cannot be handed over.
    if constexpr (!detail::is_adapted<MessageT> &&
      std::is_same_v<DeleterT, std::default_delete<PublishedType>>)
    {
      if (get_intra_process_subscription_count()) {
        share(
          std::make_shared<detail::intra_process::TypedMessage<PublishedType>>(std::move(message)));
      }
    }
  }
  template<
    class T, std::enable_if_t<
      std::is_same_v<T, ROSMessageType> && !std::is_same_v<T, PublishedType>, int> = 0>
  void publish(const T & message)
  {
    publish_message(&message);
  }
  void publish(const SerializedMessage & bytes) {publish_bytes(bytes);}
  void publish(const rcl_serialized_message_t & bytes)
  {
    SerializedMessage copy;
    std::memcpy(copy.resize(bytes.buffer_length), bytes.buffer, bytes.buffer_length);
    publish_bytes(copy);
  }
  void publish(LoanedMessage<ROSMessageType> && loaned) {publish_message(&loaned.get());}
  LoanedMessage<ROSMessageType> borrow_loaned_message() {return LoanedMessage<ROSMessageType>();}
};

}  // namespace rclcpp
