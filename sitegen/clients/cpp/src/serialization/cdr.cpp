#include "rosidl_typesupport_sitegen_cpp/cdr.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

#include "rosidl_typesupport_sitegen_cpp/message_type_support.hpp"

namespace rosidl_typesupport_sitegen_cpp
{

namespace
{
constexpr std::uint8_t kLittleEndian[4] = {0, 1, 0, 0};
}

Cdr Cdr::writer(std::uint8_t * out)
{
  Cdr cdr;
  cdr.mode_ = Mode::kWrite;
  std::memcpy(out, kLittleEndian, kHeader);
  cdr.out_ = out + kHeader;
  return cdr;
}

Cdr Cdr::reader(const std::uint8_t * in, std::size_t size)
{
  Cdr cdr;
  cdr.mode_ = Mode::kRead;
  cdr.ok_ = size >= kHeader && in[0] == kLittleEndian[0] && in[1] == kLittleEndian[1];
  cdr.in_ = in + kHeader;
  cdr.end_ = cdr.ok_ ? size - kHeader : 0;
  return cdr;
}

void Cdr::align(std::size_t size)
{
  const std::size_t alignment = std::min<std::size_t>(size, 8);
  const std::size_t padding = (alignment - position_ % alignment) % alignment;
  if (mode_ == Mode::kWrite) {std::memset(out_ + position_, 0, padding);}
  position_ += padding;
}

void Cdr::too_long(std::size_t size, std::size_t bound)
{
  throw std::length_error(
    "the length of a string is " + std::to_string(size) + "; the maximum is " + std::to_string(bound));
}

bool Cdr::room(std::size_t size)
{
  if (mode_ == Mode::kRead) {ok_ = ok_ && position_ <= end_ && size <= left();}
  return ok_;
}

void Cdr::bytes(void * data, std::size_t size)
{
  if (!room(size)) {return;}
  if (mode_ == Mode::kWrite) {
    std::memcpy(out_ + position_, data, size);
  } else if (mode_ == Mode::kRead) {
    std::memcpy(data, in_ + position_, size);
  }
  position_ += size;
}

void Cdr::block(void * data, std::size_t size, std::size_t count)
{
  align(size);
  bytes(data, size * count);
}

std::size_t Cdr::length(std::size_t count)
{
  auto value = static_cast<std::uint32_t>(count);
  block(&value, sizeof(value), 1);
  return ok_ ? value : 0;
}

void Cdr::operator()(bool & value)
{
  std::uint8_t byte = value;
  bytes(&byte, 1);
  value = byte != 0;
}

// Native ROS 2 writes wide characters as wchar_t on Linux, four bytes.
void Cdr::wide(char16_t & value)
{
  std::uint32_t wide = value;
  block(&wide, sizeof(wide), 1);
  value = static_cast<char16_t>(wide);
}

void Cdr::operator()(std::string & value)
{
  const std::size_t size = length(value.size() + 1);
  if (mode_ != Mode::kRead) {
    bytes(const_cast<char *>(value.c_str()), size);
  } else if (room(size)) {
    const char * text = reinterpret_cast<const char *>(in_ + position_);
    // The length includes the terminating zero, which native ROS 2 does not require.
    value.assign(text, size && text[size - 1] == '\0' ? size - 1 : size);
    position_ += size;
  }
}

void Cdr::operator()(std::u16string & value)
{
  const std::size_t size = length(value.size());
  if (mode_ == Mode::kRead) {
    if (size > left() / sizeof(std::uint32_t)) {
      ok_ = false;
      return;
    }
    value.resize(size);
  }
  for (char16_t & unit : value) {wide(unit);}
}

const char * const typesupport_identifier = "rosidl_typesupport_sitegen_cpp";

std::size_t serialized_size(const MessageMembers & type, const void * message)
{
  Cdr cdr;
  type.visit(cdr, const_cast<void *>(message));
  return cdr.size();
}

void serialize(const MessageMembers & type, const void * message, std::uint8_t * out)
{
  Cdr cdr = Cdr::writer(out);
  type.visit(cdr, const_cast<void *>(message));
}

bool deserialize(
  const MessageMembers & type, void * message, const std::uint8_t * in, std::size_t size)
{
  Cdr cdr = Cdr::reader(in, size);
  if (cdr.ok()) {type.visit(cdr, message);}
  return cdr.ok();
}

const rosidl_message_type_support_t * find(
  const rosidl_message_type_support_t * handle, const char * identifier)
{
  return std::strcmp(handle->typesupport_identifier, identifier) == 0 ? handle : nullptr;
}

}  // namespace rosidl_typesupport_sitegen_cpp
