// Each thread has its own stack: while one thread waits, the others run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rclcpp
{
namespace detail
{

/// What runs on a stack of its own.
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

/// The thread that runs; null is main().
extern Thread * current_thread;

/// ros_wait() on any stack. Returns when anything happened, also at another stack.
int suspend(double milliseconds);

/// End the waits of all stacks.
void wake();

/// A message was sent, perhaps to an endpoint of this program for which another stack waits.
void sent();

/// Call `body(thread)` on a stack of its own when the caller waits. False without memory.
bool launch(void (* body)(Thread *), Thread * thread);

}  // namespace detail
}  // namespace rclcpp
