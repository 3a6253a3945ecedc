#pragma once

#include <mutex>

namespace rcpputils
{

/// Threads of a page have no priorities that could be inherited.
using PIMutex = std::mutex;
using RecursivePIMutex = std::recursive_mutex;

}  // namespace rcpputils
