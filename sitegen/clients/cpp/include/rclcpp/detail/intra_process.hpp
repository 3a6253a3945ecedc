// Intra-process communication: messages that pass between nodes of a program without being copied. The
// serialized bytes are sent as well, so that order, history and filters are the same for all messages; a
// subscription that takes the bytes of such a message gets the message itself instead.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

namespace rclcpp
{
namespace detail
{
namespace intra_process
{

/// A message kept for the subscriptions that have not taken it.
class Message
{
public:
  virtual ~Message() = default;
  /// The number of these subscriptions.
  std::size_t left = 0;
};

template<class MessageT>
class TypedMessage : public Message
{
public:
  explicit TypedMessage(std::unique_ptr<MessageT> message)
  : message_(std::move(message)) {}

  const MessageT & get() const {return *message_;}
  std::unique_ptr<MessageT> take() {return std::move(message_);}

private:
  std::unique_ptr<MessageT> message_;
};

/// Add an intra-process subscription to `topic`, or remove one.
void subscribe(const std::string & topic, bool adds);
/// The number of intra-process subscriptions to `topic`.
std::size_t subscriptions(const std::string & topic);
/// Keep a message that the publisher `gid` sent as `sequence`; of each publisher, `depth` at most.
void put(
  double gid, std::uint64_t sequence, std::shared_ptr<Message> message, std::size_t subscriptions,
  std::size_t depth);
/// Drop the messages of a publisher.
void forget(double gid);
/// Take a message, or null. The caller is its only owner if none are `left` and no other holds it.
std::shared_ptr<Message> take(double gid, std::uint64_t sequence);

}  // namespace intra_process
}  // namespace detail
}  // namespace rclcpp
