#pragma once

#include <memory>

#include "rclcpp/allocator/allocator_deleter.hpp"

namespace rclcpp
{
namespace allocator
{

template<typename T, typename AllocatorT>
using AllocRebind = typename std::allocator_traits<AllocatorT>::template rebind_traits<T>;

}  // namespace allocator
}  // namespace rclcpp
