// What C++ has for threads, each kind once, with an order of lines that no scheduler may change.
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <future>
#include <memory>
#include <mutex>
#include <queue>
#include <set>
#include <shared_mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "rclcpp/rclcpp.hpp"

using namespace std::chrono_literals;

void count()
{
  int total = 0;
  std::mutex mutex;
  std::set<std::thread::id> ids;
  std::vector<std::thread> threads;
  for (int i = 0; i < 20; ++i) {
    threads.emplace_back([&] {
        for (int j = 0; j < 5; ++j) {
          std::lock_guard<std::mutex> guard(mutex);
          const int before = total;
          std::this_thread::sleep_for(100us);  // the lock is held: nobody may come between
          total = before + 1;
          ids.insert(std::this_thread::get_id());
        }
      });
  }
  for (auto & thread : threads) {thread.join();}
  std::printf("count %d, ids %zu, mine %d\n", total, ids.size(),
    static_cast<int>(ids.count(std::this_thread::get_id())));
}

void queue()
{
  std::mutex mutex;
  std::condition_variable arrived;
  std::queue<int> items;
  std::string got;
  std::thread consumer([&] {
      while (true) {
        std::unique_lock<std::mutex> lock(mutex);
        arrived.wait(lock, [&] {return !items.empty();});
        const int item = items.front();
        items.pop();
        if (item < 0) {return;}
        got += std::to_string(item) + " ";
      }
    });
  for (const int item : {1, 2, 3, -1}) {
    std::lock_guard<std::mutex> guard(mutex);
    items.push(item);
    arrived.notify_one();
  }
  consumer.join();
  std::unique_lock<std::mutex> lock(mutex);
  const auto begin = std::chrono::steady_clock::now();
  const auto status = arrived.wait_for(lock, 30ms);
  const bool late = std::chrono::steady_clock::now() - begin >= 29ms;
  std::printf("queue %s%s %d\n", got.c_str(),
    status == std::cv_status::timeout ? "timeout" : "woken", late);
}

void futures()
{
  auto sum = std::async(std::launch::async, [] {std::this_thread::sleep_for(20ms); return 42;});
  const bool early = sum.wait_for(0s) == std::future_status::ready;
  auto failing = std::async(std::launch::async, []() -> int {throw std::runtime_error("of async");});
  std::string text;
  try {
    failing.get();
  } catch (const std::runtime_error & error) {
    text = error.what();
  }
  std::promise<std::string> promise;
  auto said = promise.get_future();
  std::thread([promise = std::move(promise)]() mutable {
      std::this_thread::sleep_for(1ms);
      promise.set_value_at_thread_exit("at last");
    }).detach();
  std::printf("futures %d %d %s %s\n", early, sum.get(), text.c_str(), said.get().c_str());
}

// Exceptions that are handled while others are: each thread has its own. Far apart: without JSPI, those
// of threads that go on at the same moment may be mixed up.
void exceptions()
{
  std::string order;
  const auto nested = [&order](const char * name, std::chrono::milliseconds first) {
      try {
        throw std::runtime_error(name);
      } catch (const std::runtime_error & error) {
        std::this_thread::sleep_for(first);
        try {
          throw;
        } catch (const std::exception & again) {
          order += std::string(again.what()) + error.what() + " ";
        }
      }
    };
  std::thread one(nested, "a", 150ms);
  std::thread two(nested, "b", 5ms);
  nested("c", 400ms);
  one.join();
  two.join();
  std::printf("exceptions %s\n", order.c_str());
}

void locks()
{
  std::recursive_mutex again;
  std::lock_guard<std::recursive_mutex> first(again);
  std::lock_guard<std::recursive_mutex> second(again);
  bool other = true;
  std::thread([&] {other = again.try_lock();}).join();
  std::shared_mutex readers;
  std::shared_lock<std::shared_mutex> reading(readers);
  bool may_read = false;
  bool may_write = true;
  std::thread([&] {
      may_read = readers.try_lock_shared();
      if (may_read) {readers.unlock_shared();}
      may_write = readers.try_lock();
    }).join();
  std::once_flag once;
  int calls = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 3; ++i) {
    threads.emplace_back([&] {
        std::call_once(once, [&] {std::this_thread::sleep_for(5ms); ++calls;});
        if (calls != 1) {calls = 100;}
      });
  }
  for (auto & thread : threads) {thread.join();}
  std::timed_mutex timed;
  std::lock_guard<std::timed_mutex> held(timed);
  bool got = true;
  std::thread([&] {got = timed.try_lock_for(10ms);}).join();
  std::printf("locks %d %d %d %d %d\n", other, may_read, may_write, calls, got);
}

void turns()
{
  std::atomic<bool> flag{false};
  std::thread setter([&] {flag = true;});
  while (!flag) {std::this_thread::yield();}
  setter.join();
  std::string order;
  std::thread rate([&] {
      rclcpp::WallRate rate(200.0);
      for (int i = 0; i < 3; ++i) {
        rate.sleep();
        order += std::to_string(i);
      }
    });
  rate.join();
  std::printf("turns %s\n", order.c_str());
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  count();
  queue();
  futures();
  exceptions();
  locks();
  turns();
  // Many, one after the other: their stacks are used again.
  for (int i = 0; i < 2000; ++i) {std::thread([] {}).join();}
  std::puts("done");
  std::thread([] {throw std::runtime_error("left a thread");}).join();
}
