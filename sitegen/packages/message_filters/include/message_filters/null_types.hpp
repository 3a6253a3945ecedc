#pragma once

#include <memory>

#include "message_filters/connection.hpp"
#include "message_filters/message_traits.hpp"

namespace message_filters
{

/// Stands for an input that a synchronizer does not have.
struct NullType {};
using NullTypeConstPtr = std::shared_ptr<NullType const>;

/// A filter without messages.
template<class M>
struct NullFilter
{
  template<typename C>
  Connection registerCallback(const C &) {return Connection();}
};

namespace message_traits
{

template<>
struct TimeStamp<NullType>
{
  static rclcpp::Time value(const NullType &) {return rclcpp::Time();}
};

}  // namespace message_traits
}  // namespace message_filters
