// The type support of a message: its name, its hash and its fields.
#pragma once

#include <cstddef>
#include <cstdint>

#include "rosidl_runtime_c/message_type_support_struct.h"
#include "rosidl_runtime_cpp/message_initialization.hpp"
#include "rosidl_typesupport_cpp/message_type_support.hpp"
#include "rosidl_typesupport_sitegen_cpp/cdr.hpp"

namespace rosidl_typesupport_sitegen_cpp
{

extern const char * const typesupport_identifier;

/// The data that `rosidl_message_type_support_t::data` points to.
struct MessageMembers
{
  const char * name;  // as in `ros2 topic list -t`: std_msgs/msg/String
  const char * hash;  // RIHS01_…
  /// Its fields, see runtime/messages/filter/fields.js; empty for the parts of services and
  /// actions, to which content filters do not apply.
  const char * definition;
  void (* visit)(Cdr & cdr, void * message);
  void * (* create)();
  void (* destroy)(void * message);
};

std::size_t serialized_size(const MessageMembers & type, const void * message);
/// Write `message` to `out`, which has serialized_size() bytes.
void serialize(const MessageMembers & type, const void * message, std::uint8_t * out);
/// Read `message`; return false, with the message partly filled, if the bytes are not of this type.
bool deserialize(
  const MessageMembers & type, void * message, const std::uint8_t * in, std::size_t size);

const rosidl_message_type_support_t * find(
  const rosidl_message_type_support_t * handle, const char * identifier);

template<class Message>
const rosidl_message_type_support_t * handle_of(
  const char * name, const char * hash, const char * definition)
{
  static const MessageMembers members = {
    name, hash, definition,
    [](Cdr & cdr, void * message) {cdr(*static_cast<Message *>(message));},
    []() -> void * {return new Message(rosidl_runtime_cpp::MessageInitialization::ALL);},
    [](void * message) {delete static_cast<Message *>(message);},
  };
  static const rosidl_message_type_support_t handle = {
    typesupport_identifier, &members, find, nullptr, nullptr, nullptr};
  return &handle;
}

template<class Message>
const MessageMembers & members_of()
{
  const auto handle = rosidl_typesupport_cpp::get_message_type_support_handle<Message>();
  return *static_cast<const MessageMembers *>(handle->data);
}

/// Linked only into programs that look up services by name.
[[gnu::weak]] void note_service(const MessageMembers & request, const MessageMembers & response);

template<class Request, class Response>
bool know_service()
{
  if (!note_service) {return false;}
  note_service(members_of<Request>(), members_of<Response>());
  return true;
}

}  // namespace rosidl_typesupport_sitegen_cpp
