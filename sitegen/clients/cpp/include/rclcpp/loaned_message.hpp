#pragma once

#include <utility>

namespace rclcpp
{

/// A message to fill and publish. No middleware lends one here, so it is made as any other.
template<typename MessageT>
class LoanedMessage
{
public:
  bool is_valid() const {return true;}
  MessageT & get() const {return message_;}
  MessageT release() {return std::move(message_);}

private:
  mutable MessageT message_;
};

}  // namespace rclcpp
