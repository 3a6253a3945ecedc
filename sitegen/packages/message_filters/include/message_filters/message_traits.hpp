// Properties of messages that filters use. Both can be specialized for messages without a header.
#pragma once

#include <string>
#include <type_traits>
#include <utility>

#include "rclcpp/time.hpp"

namespace message_filters
{
namespace message_traits
{

template<typename M, typename = void>
struct HasHeader : std::false_type {};
template<typename M>
struct HasHeader<M, std::void_t<decltype(std::declval<const M &>().header.stamp)>>
  : std::true_type {};

template<typename M, typename Enable = void>
struct TimeStamp
{
  static rclcpp::Time value(const M & message)
  {
    static_assert(
      HasHeader<M>::value,
      "a message without a header has no time: specialize message_filters::message_traits::TimeStamp");
    return rclcpp::Time(message.header.stamp, RCL_ROS_TIME);
  }
};

template<typename M, typename Enable = void>
struct FrameId
{
  static std::string value(const M & message)
  {
    static_assert(
      HasHeader<M>::value,
      "a message without a header has no frame: specialize message_filters::message_traits::FrameId");
    return message.header.frame_id;
  }
};

}  // namespace message_traits
}  // namespace message_filters
