#pragma once

#include <memory>

namespace rclcpp
{
namespace allocator
{

/// Frees memory that an allocator allocated.
template<typename AllocatorT>
class AllocatorDeleter
{
  template<typename OtherT>
  using Rebound = typename std::allocator_traits<AllocatorT>::template rebind_alloc<OtherT>;

public:
  AllocatorDeleter() = default;
  explicit AllocatorDeleter(AllocatorT * allocator)
  : allocator_(allocator) {}
  template<typename OtherT>
  AllocatorDeleter(const AllocatorDeleter<OtherT> & other)  // NOLINT: implicit upstream
  : allocator_(other.get_allocator()) {}

  template<typename T>
  void operator()(T * pointer)
  {
    Rebound<T> allocator(*allocator_);
    std::allocator_traits<Rebound<T>>::destroy(allocator, pointer);
    std::allocator_traits<Rebound<T>>::deallocate(allocator, pointer, 1);
  }

  AllocatorT * get_allocator() const {return allocator_;}
  void set_allocator(AllocatorT * allocator) {allocator_ = allocator;}

private:
  AllocatorT * allocator_ = nullptr;
};

template<typename AllocatorT, typename DeleterT>
void set_allocator_for_deleter(DeleterT * deleter, AllocatorT * allocator)
{
  deleter->set_allocator(allocator);
}
template<typename AllocatorT, typename T>
void set_allocator_for_deleter(std::default_delete<T> *, AllocatorT *) {}

/// The deleter for a `T` that `AllocatorT` allocated.
template<typename AllocatorT, typename T>
using Deleter = std::conditional_t<
  std::is_same_v<
    typename std::allocator_traits<AllocatorT>::template rebind_alloc<T>, std::allocator<T>>,
  std::default_delete<T>, AllocatorDeleter<AllocatorT>>;

}  // namespace allocator
}  // namespace rclcpp
