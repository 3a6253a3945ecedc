#pragma once

#include <cstddef>

#include "rclcpp/message_memory_strategy.hpp"

namespace rclcpp
{
namespace strategies
{
namespace message_pool_memory_strategy
{

template<typename MessageT, std::size_t Size>
class MessagePoolMemoryStrategy : public message_memory_strategy::MessageMemoryStrategy<MessageT>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(MessagePoolMemoryStrategy)
};

}  // namespace message_pool_memory_strategy
}  // namespace strategies
}  // namespace rclcpp
