#pragma once

#include <mutex>

#include "rcpputils/thread_safety_annotations.hpp"

namespace rcpputils
{

template<class MutexT>
class unique_lock : public std::unique_lock<MutexT>
{
public:
  explicit unique_lock(MutexT & mutex)
  : std::unique_lock<MutexT>(mutex) {}
};

}  // namespace rcpputils
