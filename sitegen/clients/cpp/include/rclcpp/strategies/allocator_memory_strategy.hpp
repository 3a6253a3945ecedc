#pragma once

#include <memory>
#include <utility>

#include "rclcpp/memory_strategy.hpp"

namespace rclcpp
{
namespace memory_strategies
{
namespace allocator_memory_strategy
{

template<typename AllocatorT = std::allocator<void>>
class AllocatorMemoryStrategy : public memory_strategy::MemoryStrategy
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(AllocatorMemoryStrategy<AllocatorT>)

  AllocatorMemoryStrategy() = default;
  explicit AllocatorMemoryStrategy(std::shared_ptr<AllocatorT> allocator)
  : allocator_(std::move(allocator)) {}

private:
  std::shared_ptr<AllocatorT> allocator_;
};

}  // namespace allocator_memory_strategy
}  // namespace memory_strategies
}  // namespace rclcpp
