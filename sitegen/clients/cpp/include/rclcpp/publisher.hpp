#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "rclcpp/detail/receiver.hpp"
#include "rclcpp/event_handler.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/serialized_message.hpp"

namespace rclcpp
{

struct PublisherOptions
{
  PublisherEventCallbacks event_callbacks;
  /// Log what is incompatible.
  bool use_default_callbacks = true;
  CallbackGroup::SharedPtr callback_group = nullptr;
};

class PublisherBase
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(PublisherBase)

  PublisherBase(
    const node_interfaces::NodeBaseInterface & node, const std::string & topic,
    const detail::MessageMembers & type, const QoS & qos, const PublisherOptions & options);
  virtual ~PublisherBase() = default;

  const char * get_topic_name() const {return endpoint_.name().c_str();}
  std::size_t get_queue_size() const {return endpoint_.qos().depth();}
  std::size_t get_subscription_count() const {return endpoint_.matched();}
  QoS get_actual_qos() const {return endpoint_.qos();}
  /// Say that it is alive, where liveliness is manual.
  bool assert_liveliness() const;
  /// Wait until all reliable subscriptions have got all; false if they had not within `timeout`, which
  /// is without end when negative.
  template<class Rep = std::int64_t, class Period = std::milli>
  bool wait_for_all_acked(
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1)) const
  {
    return wait_until_sent(std::chrono::duration<double, std::milli>(timeout).count());
  }

  /// What calls back for its events.
  std::shared_ptr<detail::Executable> events() const {return events_;}

protected:
  void publish_message(const void * message);
  void publish_bytes(const SerializedMessage & bytes);

private:
  /// Where all has to be kept and there is no room, wait for some, and throw RCLError if none comes.
  void send(const std::uint8_t * data, std::uint32_t size);
  bool wait_until_sent(double milliseconds) const;

  const detail::MessageMembers & type_;
  detail::Endpoint endpoint_;
  std::shared_ptr<detail::Events> events_;
};

template<class MessageT, class AllocatorT = std::allocator<void>>
class Publisher : public PublisherBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Publisher<MessageT, AllocatorT>)

  Publisher(
    const node_interfaces::NodeBaseInterface & node, const std::string & topic, const QoS & qos,
    const PublisherOptions & options = PublisherOptions())
  : PublisherBase(
      node, topic, rosidl_typesupport_sitegen_cpp::members_of<MessageT>(), qos, options) {}

  void publish(const MessageT & message) {publish_message(&message);}
  void publish(std::unique_ptr<MessageT> message) {publish_message(message.get());}
  void publish(const SerializedMessage & bytes) {publish_bytes(bytes);}
};

}  // namespace rclcpp
