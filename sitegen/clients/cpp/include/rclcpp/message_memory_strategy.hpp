#pragma once

#include <memory>
#include <utility>

#include "rclcpp/macros.hpp"

namespace rclcpp
{
namespace message_memory_strategy
{

/// Accepted and unused: messages use the standard allocator.
template<typename MessageT, typename AllocatorT = std::allocator<void>>
class MessageMemoryStrategy
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(MessageMemoryStrategy)

  MessageMemoryStrategy() = default;
  explicit MessageMemoryStrategy(std::shared_ptr<AllocatorT> allocator)
  : allocator_(std::move(allocator)) {}
  virtual ~MessageMemoryStrategy() = default;

  static SharedPtr create_default()
  {
    return std::make_shared<MessageMemoryStrategy<MessageT, AllocatorT>>();
  }

private:
  std::shared_ptr<AllocatorT> allocator_;
};

}  // namespace message_memory_strategy
}  // namespace rclcpp
