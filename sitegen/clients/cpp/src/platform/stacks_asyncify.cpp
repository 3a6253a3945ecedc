// Stacks with Asyncify: fibers. Only main() waits for the browser; other threads switch to it.
#include "rclcpp/detail/stacks.hpp"

#include <emscripten/fiber.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "rclcpp/detail/host.h"

namespace rclcpp
{
namespace detail
{

namespace
{

constexpr std::size_t kSize = 256 * 1024;
constexpr std::size_t kUnwound = 64 * 1024;  // where Asyncify saves the frames of a suspended stack
constexpr std::size_t kAlignment = 16;

struct Stack
{
  emscripten_fiber_t fiber;
  char * memory;
  void (* body)(Thread *);
  Thread * thread;
  double until = 0;  // when its wait times out
};

emscripten_fiber_t main_fiber;
std::vector<Stack *> * running = nullptr;  // null before the first thread
std::vector<Stack *> * pool = nullptr;
Stack * current = nullptr;
bool woken = false;
// Set by the first thread, so that programs without threads do not link fibers.
int (* schedule)(double milliseconds) = ros_wait;

void enter(void * argument)
{
  auto stack = static_cast<Stack *>(argument);
  stack->body(stack->thread);
  running->erase(std::find(running->begin(), running->end(), stack));
  pool->push_back(stack);
  emscripten_fiber_swap(&stack->fiber, &main_fiber);
}

void give_turns()
{
  const auto stacks = *running;
  for (Stack * stack : stacks) {
    current = stack;
    current_thread = stack->thread;
    emscripten_fiber_swap(&main_fiber, &stack->fiber);
    current = nullptr;
    current_thread = nullptr;
  }
}

int wait_with_others(double milliseconds)
{
  const double now = ros_now();
  if (current) {
    Stack * const me = current;
    me->until = milliseconds < 0 ? std::numeric_limits<double>::infinity() : now + milliseconds;
    emscripten_fiber_swap(&me->fiber, &main_fiber);
    return 0;  // main() handles signals
  }
  double until =
    milliseconds < 0 ? std::numeric_limits<double>::infinity() : now + milliseconds;
  for (const Stack * stack : *running) {until = std::min(until, stack->until);}
  if (woken) {until = now;}
  woken = false;
  const int signal =
    ros_wait(until == std::numeric_limits<double>::infinity() ? -1 : std::max(0.0, until - now));
  give_turns();
  return signal;
}

}  // namespace

Thread * current_thread = nullptr;

int suspend(double milliseconds) {return schedule(milliseconds);}

void wake()
{
  woken = true;
  ros_wake();
}

void sent() {woken = true;}

bool launch(void (* body)(Thread *), Thread * thread)
{
  if (!running) {
    running = new std::vector<Stack *>;
    pool = new std::vector<Stack *>;
    schedule = wait_with_others;
    emscripten_fiber_init_from_current_context(
      &main_fiber, std::aligned_alloc(kAlignment, kUnwound), kUnwound);
  }
  if (pool->empty()) {
    auto memory = static_cast<char *>(std::aligned_alloc(kAlignment, kSize + kUnwound));
    if (!memory) {return false;}
    pool->push_back(new Stack{{}, memory, nullptr, nullptr});
  }
  Stack * stack = pool->back();
  pool->pop_back();
  stack->body = body;
  stack->thread = thread;
  stack->until = 0;
  emscripten_fiber_init(
    &stack->fiber, enter, stack, stack->memory, kSize, stack->memory + kSize, kUnwound);
  running->push_back(stack);
  return true;
}

}  // namespace detail
}  // namespace rclcpp
