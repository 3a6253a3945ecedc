#pragma once

#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "rclcpp/clock.hpp"
#include "rclcpp/time.hpp"

namespace message_filters
{

using M_string = std::map<std::string, std::string>;
using M_stringPtr = std::shared_ptr<M_string>;

template<typename M>
struct DefaultMessageCreator
{
  std::shared_ptr<M> operator()() {return std::make_shared<M>();}
};

/// A message and its time of arrival.
template<typename M>
class MessageEvent
{
public:
  using Message = std::remove_const_t<M>;
  using ConstMessage = const Message;
  using MessagePtr = std::shared_ptr<Message>;
  using ConstMessagePtr = std::shared_ptr<ConstMessage>;

  MessageEvent() = default;
  MessageEvent(ConstMessagePtr message)  // NOLINT: implicit upstream
  : MessageEvent(std::move(message), now()) {}
  MessageEvent(ConstMessagePtr message, rclcpp::Time receipt_time)
  : message_(std::move(message)), receipt_time_(receipt_time) {}
  template<
    typename Other,
    std::enable_if_t<std::is_same_v<std::remove_const_t<Other>, Message> &&
    !std::is_same_v<Other, M>, int> = 0>
  MessageEvent(const MessageEvent<Other> & other)  // NOLINT: implicit upstream
  : MessageEvent(other.getConstMessage(), other.getReceiptTime()) {}

  /// The message; a copy if it is mutable.
  std::shared_ptr<M> getMessage() const
  {
    if constexpr (std::is_const_v<M>) {
      return message_;
    } else {
      return std::make_shared<Message>(*message_);
    }
  }
  const ConstMessagePtr & getConstMessage() const {return message_;}
  const rclcpp::Time & getReceiptTime() const {return receipt_time_;}

  bool operator<(const MessageEvent & other) const {return key() < other.key();}
  bool operator==(const MessageEvent & other) const {return key() == other.key();}
  bool operator!=(const MessageEvent & other) const {return !(*this == other);}

private:
  static rclcpp::Time now()
  {
    static const rclcpp::Clock clock;
    return clock.now();
  }
  std::pair<const void *, std::int64_t> key() const
  {
    return {message_.get(), receipt_time_.nanoseconds()};
  }

  ConstMessagePtr message_;
  rclcpp::Time receipt_time_;
};

}  // namespace message_filters
