#pragma once

#include <mutex>

namespace rcpputils
{

/// Threads in a page have equal priority, so there is nothing to inherit.
using PIMutex = std::mutex;
using RecursivePIMutex = std::recursive_mutex;

}  // namespace rcpputils
