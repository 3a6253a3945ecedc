#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "rcl/types.h"

namespace rclcpp
{

/// The bytes of a message, with the CDR header.
class SerializedMessage
{
public:
  SerializedMessage() = default;
  explicit SerializedMessage(std::size_t initial_capacity) {reserve(initial_capacity);}
  SerializedMessage(const SerializedMessage & other)
  : bytes_(other.bytes_) {refresh();}
  SerializedMessage(SerializedMessage && other) noexcept
  : bytes_(std::move(other.bytes_))
  {
    refresh();
    other.refresh();
  }
  SerializedMessage & operator=(SerializedMessage other)
  {
    bytes_.swap(other.bytes_);
    refresh();
    return *this;
  }

  std::size_t size() const {return message_.buffer_length;}
  std::size_t capacity() const {return message_.buffer_capacity;}
  void reserve(std::size_t capacity)
  {
    bytes_.resize(capacity);
    refresh();
    message_.buffer_length = 0;
  }
  /// Resize to `size` bytes and return the buffer, for the caller to fill.
  std::uint8_t * resize(std::size_t size)
  {
    bytes_.resize(size);
    refresh();
    return message_.buffer;
  }
  rcl_serialized_message_t & get_rcl_serialized_message() {return message_;}
  const rcl_serialized_message_t & get_rcl_serialized_message() const {return message_;}

private:
  void refresh() {message_ = {bytes_.data(), bytes_.size(), bytes_.size(), {}};}

  std::vector<std::uint8_t> bytes_;
  rcl_serialized_message_t message_{};
};

}  // namespace rclcpp
