// Stacks with JSPI: the browser suspends the WebAssembly stack; we switch the stack in linear memory.
#include "rclcpp/detail/stacks.hpp"

#include <emscripten/stack.h>

#include <cstdlib>

#include "rclcpp/detail/host.h"

extern "C" void stackRestore(std::uintptr_t top);

namespace rclcpp
{
namespace detail
{

namespace
{

constexpr std::size_t kSize = 256 * 1024;
constexpr std::size_t kAlignment = 16;

/// A stack in linear memory and the function that runs on it.
struct Stack
{
  char * memory;
  void (* body)(Thread *);
  Thread * thread;
};

// Free stacks. A thread releases its own as its last step: nothing else runs before it has ended.
std::vector<Stack *> & pool()
{
  static auto * stacks = new std::vector<Stack *>;
  return *stacks;
}

// Not inlined: its frame must be on the new stack.
__attribute__((noinline)) void run(Stack * stack)
{
  current_thread = stack->thread;
  stack->body(stack->thread);
  current_thread = nullptr;
  pool().push_back(stack);
}

void enter(void * stack)
{
  stackRestore(reinterpret_cast<std::uintptr_t>(static_cast<Stack *>(stack)->memory) + kSize);
  run(static_cast<Stack *>(stack));
}

}  // namespace

Thread * current_thread = nullptr;

int suspend(double milliseconds)
{
  Thread * const thread = current_thread;
  const std::uintptr_t top = emscripten_stack_get_current();
  const int signal = ros_wait(milliseconds);
  stackRestore(top);
  current_thread = thread;
  return signal;
}

void wake() {ros_wake();}

void sent() {}  // the page has ended the waits

bool launch(void (* body)(Thread *), Thread * thread)
{
  if (pool().empty()) {
    auto memory = static_cast<char *>(std::aligned_alloc(kAlignment, kSize));
    if (!memory) {return false;}
    pool().push_back(new Stack{memory, nullptr, nullptr});
  }
  Stack * stack = pool().back();
  pool().pop_back();
  stack->body = body;
  stack->thread = thread;
  ros_spawn(enter, stack);
  return true;
}

}  // namespace detail
}  // namespace rclcpp

// Each thread has its own exceptions in flight. The linker replaces libc++abi's functions with these.
extern "C" {

void * __wrap___cxa_get_globals(void)
{
  static void * of_main[2];
  const auto thread = rclcpp::detail::current_thread;
  return thread ? thread->exceptions : of_main;
}

void * __wrap___cxa_get_globals_fast(void) {return __wrap___cxa_get_globals();}

}  // extern "C"
