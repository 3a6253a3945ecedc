#pragma once

#include "rclcpp/serialized_message.hpp"
#include "rosidl_typesupport_sitegen_cpp/message_type_support.hpp"

namespace rclcpp
{

/// Serializes and deserializes messages of a type known at run time.
class SerializationBase
{
public:
  explicit SerializationBase(const rosidl_message_type_support_t * type_support);
  virtual ~SerializationBase() = default;

  void serialize_message(const void * message, SerializedMessage * bytes) const;
  /// Throws RCLError if the bytes are not a valid message of this type.
  void deserialize_message(const SerializedMessage * bytes, void * message) const;

private:
  const rosidl_typesupport_sitegen_cpp::MessageMembers & type_;
};

template<typename MessageT>
class Serialization : public SerializationBase
{
public:
  Serialization()
  : SerializationBase(rosidl_typesupport_cpp::get_message_type_support_handle<MessageT>()) {}
};

}  // namespace rclcpp
