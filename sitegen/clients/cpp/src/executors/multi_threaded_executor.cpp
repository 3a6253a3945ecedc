// In a file of its own, so that programs without this executor do not link threads.
#include "rclcpp/executors/multi_threaded_executor.hpp"

#include <thread>
#include <vector>

namespace rclcpp
{
namespace executors
{

namespace
{
// Threads are stacks here, so their number does not depend on processors, and they cost little.
constexpr std::size_t kThreads = 4;
}  // namespace

MultiThreadedExecutor::MultiThreadedExecutor(
  const ExecutorOptions & options, std::size_t number_of_threads, bool, std::chrono::nanoseconds)
: Executor(options), threads_(number_of_threads ? number_of_threads : kThreads)
{
}

void MultiThreadedExecutor::spin()
{
  begin_spinning("spin");
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < threads_; ++i) {others.emplace_back([this] {work();});}
  work();
  for (auto & other : others) {other.join();}
  end_spinning();
}

}  // namespace executors
}  // namespace rclcpp
