// Coroutines as libraries make them of fibers, whose header they include within extern "C".
extern "C" {
#include <emscripten/fiber.h>
}

#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace std::chrono_literals;

// Compilers take the thread of a function for constant, and would ask for it only once.
std::thread::id (* volatile here)() = std::this_thread::get_id;

class Coroutine
{
public:
  explicit Coroutine(std::function<void(Coroutine &)> body)
  : body_(std::move(body))
  {
    emscripten_fiber_init(&fiber_, start, this, stack_, sizeof(stack_), saved_, sizeof(saved_));
  }

  /// Go on until the next pause; false if the function has returned.
  bool resume()
  {
    emscripten_fiber_init_from_current_context(&caller_, callers_, sizeof(callers_));
    emscripten_fiber_swap(&caller_, &fiber_);
    return !done_;
  }

  void pause() {emscripten_fiber_swap(&fiber_, &caller_);}

private:
  static void start(void * argument)
  {
    auto self = static_cast<Coroutine *>(argument);
    self->body_(*self);
    self->done_ = true;
    self->pause();
  }

  alignas(16) char stack_[64 * 1024];
  alignas(16) char saved_[16 * 1024];
  alignas(16) char callers_[16 * 1024];
  emscripten_fiber_t fiber_;
  emscripten_fiber_t caller_;
  std::function<void(Coroutine &)> body_;
  bool done_ = false;
};

std::unique_ptr<Coroutine> coroutine(std::function<void(Coroutine &)> body)
{
  return std::make_unique<Coroutine>(std::move(body));
}

void turns()
{
  std::string said;
  const auto counting = [&said](char name) {
      return [&said, name](Coroutine & self) {
               for (int i = 0; i < 3; ++i) {
                 said += std::string(1, name) + std::to_string(i) + " ";
                 self.pause();
               }
             };
    };
  auto first = coroutine(counting('a')), second = coroutine(counting('b'));
  while (first->resume() && second->resume()) {said += "| ";}
  std::printf("turns %s\n", said.c_str());
}

void waits()
{
  bool ticked = false;
  std::thread other([&ticked] {
      std::this_thread::sleep_for(10ms);
      ticked = true;
    });
  std::recursive_mutex mutex;
  std::lock_guard<std::recursive_mutex> guard(mutex);
  const auto caller = here();
  bool same = false, before = true;
  auto waiting = coroutine([&](Coroutine & self) {
        std::lock_guard<std::recursive_mutex> again(mutex);
        before = ticked;
        while (!ticked) {std::this_thread::sleep_for(5ms);}
        self.pause();
        same = here() == caller;
      });
  while (waiting->resume()) {}
  std::printf("waits %d %d thread %d\n", before, ticked, same);
  other.join();
}

void nested()
{
  std::string said;
  auto outer = coroutine([&said](Coroutine & self) {
        auto inner = coroutine([&said](Coroutine & self) {
              said += "inner ";
              self.pause();
              throw std::runtime_error("unreachable");
            });
        inner->resume();
        try {
          said += "outer ";
          self.pause();
          throw std::runtime_error("caught ");
        } catch (const std::exception & error) {
          said += error.what();
        }
      });
  while (outer->resume()) {said += "main ";}
  std::printf("nested %s\n", said.c_str());
}

void threads()
{
  std::vector<int> counts(3);
  std::vector<std::thread> threads;
  for (auto & count : counts) {
    threads.emplace_back([&count] {
        auto counting = coroutine([&count](Coroutine & self) {
              for (int i = 0; i < 5; ++i) {
                const int before = count;
                std::this_thread::sleep_for(1ms);
                count = before + 1;
                self.pause();
              }
            });
        while (counting->resume()) {std::this_thread::sleep_for(1ms);}
      });
  }
  for (auto & thread : threads) {thread.join();}
  std::printf("threads %d %d %d\n", counts[0], counts[1], counts[2]);
}

void moved()
{
  std::thread::id first, second;
  auto moving = coroutine([&](Coroutine & self) {
        first = here();
        self.pause();
        second = here();
      });
  std::thread starting([&] {moving->resume();});
  const bool started_there = (starting.join(), first != here());
  moving->resume();
  std::printf("moved %d %d\n", started_there, second == here());
}

void left()
{
  int left = 0;
  for (int i = 0; i < 1000; ++i) {
    auto leaving = coroutine([&left](Coroutine & self) {
          ++left;
          self.pause();
        });
    leaving->resume();
  }
  std::printf("left %d\n", left);
}

int main()
{
  turns();
  waits();
  nested();
  threads();
  moved();
  left();
  auto failing = coroutine([](Coroutine &) {throw std::runtime_error("left a coroutine");});
  failing->resume();
}
