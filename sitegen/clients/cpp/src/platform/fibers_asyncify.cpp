// The functions of <emscripten/fiber.h> with Asyncify are Emscripten's, but a fiber whose function
// throws or returns ends the program. The linker replaces the function that makes fibers with this.
#include <emscripten/fiber.h>

#include <cstdlib>
#include <new>

#include "rclcpp/detail/platform.hpp"

namespace
{

/// What a fiber calls; kept at the base of its stack.
struct alignas(16) Entry
{
  em_arg_callback_func function;
  void * argument;
};

void enter(void * argument)
{
  const auto entry = static_cast<Entry *>(argument);
  rclcpp::detail::guarded([entry] {entry->function(entry->argument);});
  std::exit(0);
}

}  // namespace

extern "C" {

void __real_emscripten_fiber_init(
  emscripten_fiber_t *, em_arg_callback_func, void *, void *, std::size_t, void *, std::size_t);

void __wrap_emscripten_fiber_init(
  emscripten_fiber_t * fiber, em_arg_callback_func function, void * argument, void * stack,
  std::size_t size, void * unwound, std::size_t unwound_size)
{
  size -= sizeof(Entry);
  const auto entry = new (static_cast<char *>(stack) + size) Entry{function, argument};
  __real_emscripten_fiber_init(fiber, enter, entry, stack, size, unwound, unwound_size);
}

}  // extern "C"
