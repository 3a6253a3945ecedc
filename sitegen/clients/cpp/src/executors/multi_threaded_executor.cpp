// By itself, so that programs without it have no threads.
#include "rclcpp/executors/multi_threaded_executor.hpp"

#include <thread>
#include <vector>

namespace rclcpp
{
namespace executors
{

namespace
{
// A browser tells no program how many processors there are; these are stacks, so they cost little.
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
