// The functions of <emscripten/fiber.h> with JSPI: coroutines, which switch stacks within a thread.
#include <emscripten/fiber.h>
#include <emscripten/stack.h>

#include <cstdint>
#include <cstdlib>

#include "rclcpp/detail/host.h"
#include "rclcpp/detail/platform.hpp"
#include "rclcpp/detail/stacks.hpp"

extern "C" void stackRestore(std::uintptr_t top);

namespace
{

using rclcpp::detail::current_thread;
using rclcpp::detail::Thread;

/// The thread that switches to `fiber`, which goes on in it. Asyncify would use this field.
void * & thread_of(emscripten_fiber_t * fiber) {return fiber->asyncify_data.stack_ptr;}

// Not inlined: its frame must be on the stack of the fiber.
__attribute__((noinline)) void run(emscripten_fiber_t * fiber)
{
  current_thread = static_cast<Thread *>(thread_of(fiber));
  const auto entry = fiber->entry;
  fiber->entry = nullptr;
  rclcpp::detail::guarded([&] {entry(fiber->user_data);});
  std::exit(0);  // a fiber that ends without a switch to another ends the program
}

void enter(void * argument)
{
  const auto fiber = static_cast<emscripten_fiber_t *>(argument);
  stackRestore(reinterpret_cast<std::uintptr_t>(fiber->stack_base));
  run(fiber);
}

}  // namespace

extern "C" {

void emscripten_fiber_init(
  emscripten_fiber_t * fiber, em_arg_callback_func entry, void * argument, void * stack,
  std::size_t size, void *, std::size_t)
{
  *fiber = {};
  fiber->stack_limit = stack;
  fiber->stack_base = static_cast<char *>(stack) + size;
  fiber->entry = entry;
  fiber->user_data = argument;
}

void emscripten_fiber_init_from_current_context(emscripten_fiber_t * fiber, void *, std::size_t)
{
  *fiber = {};
}

void emscripten_fiber_swap(emscripten_fiber_t * from, emscripten_fiber_t * to)
{
  const std::uintptr_t top = emscripten_stack_get_current();
  thread_of(to) = current_thread;
  ros_swap(from, to, to->entry ? enter : nullptr);
  stackRestore(top);
  current_thread = static_cast<Thread *>(thread_of(from));
}

}  // extern "C"
