// Each thread has its own stack: while one thread waits, the others run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rclcpp
{
namespace detail
{

/// A function with its own stack.
struct Thread
{
  void * (* function)(void *);
  void * argument;
  void * result = nullptr;
  bool done = false;
  bool detached = false;
  std::vector<const void *> values = {};  // by the keys of pthread_key_create
  void * exceptions[2] = {};         // what the C++ runtime notes of those that are handled
};

/// The current thread; null is main().
extern Thread * current_thread;

/// ros_wait() on any stack. Also returns when something happened on another stack.
int suspend(double milliseconds);

/// End the waits of all stacks.
void wake();

/// Report that a message was sent; another stack of this program may be waiting for it.
void sent();

/// Call `body(thread)` on a new stack once the caller waits. False if memory is exhausted.
bool launch(void (* body)(Thread *), Thread * thread);

}  // namespace detail
}  // namespace rclcpp
