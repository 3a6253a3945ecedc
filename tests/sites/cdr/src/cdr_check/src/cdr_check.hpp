#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "rosidl_typesupport_sitegen_cpp/message_type_support.hpp"

using Bytes = std::vector<std::uint8_t>;
using rosidl_typesupport_sitegen_cpp::MessageMembers;

/// A message of any type.
class Message
{
public:
  explicit Message(const MessageMembers & type)
  : type_(type), message_(type.create(), type.destroy) {}

  bool read(const std::uint8_t * bytes, std::size_t size)
  {
    return deserialize(type_, message_.get(), bytes, size);
  }

  Bytes write() const
  {
    Bytes bytes(serialized_size(type_, message_.get()));
    serialize(type_, message_.get(), bytes.data());
    return bytes;
  }

private:
  const MessageMembers & type_;
  std::unique_ptr<void, void (*)(void *)> message_;
};

/// Read `count` variations of `valid` as `type` and say what came of them; throws when reading
/// looked beyond its input or asked for memory out of proportion to it.
std::string fuzz(
  const MessageMembers & type, const Bytes & valid, std::uint32_t seed, unsigned count);
