#pragma once

#include <utility>

namespace rclcpp
{

/// A message to fill and publish. The middleware does not support loans, so it is an ordinary message.
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
