#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "rclcpp/detail/receiver.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/serialized_message.hpp"

namespace rclcpp
{

struct PublisherOptions {};

class PublisherBase
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(PublisherBase)

  PublisherBase(
    const node_interfaces::NodeBaseInterface & node, const std::string & topic,
    const detail::MessageMembers & type, const QoS & qos);
  virtual ~PublisherBase() = default;

  const char * get_topic_name() const {return endpoint_.name().c_str();}
  std::size_t get_queue_size() const {return endpoint_.qos().depth();}
  std::size_t get_subscription_count() const {return endpoint_.matched();}
  QoS get_actual_qos() const {return endpoint_.qos();}

protected:
  void publish_message(const void * message);
  void publish_bytes(const SerializedMessage & bytes);

private:
  const detail::MessageMembers & type_;
  detail::Endpoint endpoint_;
};

template<class MessageT, class AllocatorT = std::allocator<void>>
class Publisher : public PublisherBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Publisher<MessageT, AllocatorT>)

  Publisher(
    const node_interfaces::NodeBaseInterface & node, const std::string & topic, const QoS & qos)
  : PublisherBase(
      node, topic, rosidl_typesupport_sitegen_cpp::members_of<MessageT>(), qos) {}

  void publish(const MessageT & message) {publish_message(&message);}
  void publish(std::unique_ptr<MessageT> message) {publish_message(message.get());}
  void publish(const SerializedMessage & bytes) {publish_bytes(bytes);}
};

}  // namespace rclcpp
