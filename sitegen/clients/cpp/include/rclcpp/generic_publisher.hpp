#pragma once

#include <memory>
#include <string>
#include <utility>

#include "rclcpp/publisher.hpp"

namespace rclcpp
{

namespace detail
{

/// A type known only by name.
struct NamedType
{
  explicit NamedType(std::string type)
  : name(std::move(type)), members{name.c_str(), "", "", nullptr, nullptr, nullptr} {}
  RCLCPP_DISABLE_COPY(NamedType)

  std::string name;
  MessageMembers members;
};

}  // namespace detail

/// Publishes serialized messages of a type known at run time.
class GenericPublisher : private detail::NamedType, public PublisherBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericPublisher)

  GenericPublisher(
    const node_interfaces::NodeBaseInterface & node, const std::string & topic,
    const std::string & type, const QoS & qos,
    const PublisherOptionsBase & options = PublisherOptions())
  : NamedType(type), PublisherBase(node, topic, members, qos, options) {}

  void publish(const SerializedMessage & bytes) {publish_bytes(bytes);}
};

}  // namespace rclcpp
