#include "rclcpp/serialization.hpp"

#include "rclcpp/exceptions.hpp"
#include "rmw/rmw.h"

namespace rclcpp
{

namespace
{

const rosidl_typesupport_sitegen_cpp::MessageMembers & members_of(
  const rosidl_message_type_support_t * type_support)
{
  if (!type_support) {throw std::invalid_argument("Typesupport is nullpointer.");}
  return *static_cast<const rosidl_typesupport_sitegen_cpp::MessageMembers *>(type_support->data);
}

}  // namespace

SerializationBase::SerializationBase(const rosidl_message_type_support_t * type_support)
: type_(members_of(type_support))
{
}

void SerializationBase::serialize_message(const void * message, SerializedMessage * bytes) const
{
  if (!message || !bytes) {throw std::invalid_argument("ROS message is nullpointer.");}
  const auto size = rosidl_typesupport_sitegen_cpp::serialized_size(type_, message);
  rosidl_typesupport_sitegen_cpp::serialize(type_, message, bytes->resize(size));
}

void SerializationBase::deserialize_message(const SerializedMessage * bytes, void * message) const
{
  if (!message || !bytes) {throw std::invalid_argument("ROS message is nullpointer.");}
  if (bytes->size() == 0) {
    throw exceptions::RCLError("Serialized message has a size of zero.");
  }
  const auto & raw = bytes->get_rcl_serialized_message();
  if (!rosidl_typesupport_sitegen_cpp::deserialize(
      type_, message, raw.buffer, raw.buffer_length))
  {
    throw exceptions::RCLError("Failed to deserialize serialized message.");
  }
}

}  // namespace rclcpp

extern "C" {

rmw_ret_t rmw_serialize(
  const void * ros_message, const rosidl_message_type_support_t * type_support,
  rmw_serialized_message_t * serialized_message)
{
  if (!ros_message || !type_support || !serialized_message) {return RMW_RET_INVALID_ARGUMENT;}
  const auto & type = rclcpp::members_of(type_support);
  const auto size = rosidl_typesupport_sitegen_cpp::serialized_size(type, ros_message);
  if (serialized_message->buffer_capacity < size &&
    rmw_serialized_message_resize(serialized_message, size) != RCUTILS_RET_OK)
  {
    return RMW_RET_BAD_ALLOC;
  }
  rosidl_typesupport_sitegen_cpp::serialize(type, ros_message, serialized_message->buffer);
  serialized_message->buffer_length = size;
  return RMW_RET_OK;
}

rmw_ret_t rmw_deserialize(
  const rmw_serialized_message_t * serialized_message,
  const rosidl_message_type_support_t * type_support, void * ros_message)
{
  if (!ros_message || !type_support || !serialized_message) {return RMW_RET_INVALID_ARGUMENT;}
  const bool fits = rosidl_typesupport_sitegen_cpp::deserialize(
    rclcpp::members_of(type_support), ros_message, serialized_message->buffer,
    serialized_message->buffer_length);
  return fits ? RMW_RET_OK : RMW_RET_ERROR;
}

}
