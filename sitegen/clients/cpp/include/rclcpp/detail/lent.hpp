// Messages that go from one node of a program to another by their addresses. Their bytes travel as ever,
// so order, history and filters are those of every message; who takes the bytes of one that is lent here
// gets the message itself instead of reading them.
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

/// A message that is kept for those who may still take it.
class Lent
{
public:
  virtual ~Lent() = default;
  /// How many subscriptions have not taken it yet.
  std::size_t left = 0;
};

template<class MessageT>
class LentMessage : public Lent
{
public:
  explicit LentMessage(std::unique_ptr<MessageT> message)
  : message_(std::move(message)) {}

  const MessageT & get() const {return *message_;}
  std::unique_ptr<MessageT> take() {return std::move(message_);}

private:
  std::unique_ptr<MessageT> message_;
};

/// A subscription to `topic` takes what is lent from now on, or does no more.
void borrow(const std::string & topic, bool begins);
/// How many subscriptions to `topic` do.
std::size_t borrowers(const std::string & topic);
/// Lend a message of `writer` that was published as `sequence`; `depth` of them are kept at most.
void lend(
  double writer, std::uint64_t sequence, std::shared_ptr<Lent> message, std::size_t borrowers,
  std::size_t depth);
/// A writer is gone, and what it lent.
void forget_lent(double writer);
/// What was lent, null if nothing was. Who has it is alone with it if none are `left` and no other has it.
std::shared_ptr<Lent> lent(double writer, std::uint64_t sequence);

}  // namespace detail
}  // namespace rclcpp
