// Executors and callback groups: who runs beside whom, and how spinning begins and ends.
#include <chrono>
#include <cstdio>
#include <future>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include "example_interfaces/srv/add_two_ints.hpp"
#include "rclcpp/experimental/executors/events_executor/events_executor.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rcpputils/scope_exit.hpp"
#include "std_msgs/msg/int32.hpp"

using namespace std::chrono_literals;
using AddTwoInts = example_interfaces::srv::AddTwoInts;
using Int32 = std_msgs::msg::Int32;

// Two timers whose callbacks sleep: do they overlap?
void overlap(rclcpp::CallbackGroupType type, bool same_group)
{
  auto node = std::make_shared<rclcpp::Node>("overlap");
  auto one = node->create_callback_group(type);
  auto two = same_group ? one : node->create_callback_group(type);
  int running = 0;
  int most = 0;
  int calls = 0;
  std::set<std::thread::id> ids;
  rclcpp::executors::MultiThreadedExecutor executor;
  const auto callback = [&] {
      most = std::max(most, ++running);
      ids.insert(std::this_thread::get_id());
      std::this_thread::sleep_for(20ms);
      --running;
      if (++calls == 6) {executor.cancel();}
    };
  auto first = node->create_wall_timer(5ms, callback, one);
  auto second = node->create_wall_timer(5ms, callback, two);
  executor.add_node(node);
  executor.spin();
  std::printf("overlap %d%s\n", most > 1, most > 1 && ids.size() > 1 ? ", several threads" : "");
}

// A callback that waits for an answer which another group brings.
void call_inside()
{
  auto node = std::make_shared<rclcpp::Node>("inside");
  auto service = node->create_service<AddTwoInts>(
    "add", [](AddTwoInts::Request::SharedPtr request, AddTwoInts::Response::SharedPtr response) {
      response->sum = request->a + request->b;
    });
  auto group = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
  auto client = node->create_client<AddTwoInts>("add", rclcpp::ServicesQoS(), group);
  rclcpp::executors::MultiThreadedExecutor executor;
  auto of_timer = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
  rclcpp::TimerBase::SharedPtr timer;
  timer = node->create_wall_timer(
    1ms, [&] {
      timer->cancel();
      auto request = std::make_shared<AddTwoInts::Request>();
      request->a = 40;
      request->b = 2;
      auto future = client->async_send_request(request);
      const bool done = future.wait_for(5s) == std::future_status::ready;
      std::printf("inside %d %d\n", done, done ? static_cast<int>(future.get()->sum) : 0);
      executor.cancel();
    }, of_timer);
  executor.add_node(node);
  executor.spin();
}

// A group that an executor of its own looks after, in a thread.
void own_executor()
{
  auto node = std::make_shared<rclcpp::Node>("own");
  auto group = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
  std::promise<std::thread::id> where;
  bool once = false;
  auto timer = node->create_wall_timer(
    1ms, [&] {
      if (!std::exchange(once, true)) {where.set_value(std::this_thread::get_id());}
    }, group);
  rclcpp::executors::SingleThreadedExecutor mine;
  rclcpp::executors::SingleThreadedExecutor theirs;
  mine.add_node(node);
  theirs.add_callback_group(group, node->get_node_base_interface());
  std::thread thread([&] {theirs.spin();});
  auto future = where.get_future().share();
  const auto code = mine.spin_until_future_complete(future, 5s);
  std::printf(
    "own %s, in its thread %d\n", rclcpp::to_string(code).c_str(),
    future.get() == thread.get_id());
  theirs.cancel();
  thread.join();
}

template<class ExecutorT>
void ways_to_spin(const char * name)
{
  auto node = std::make_shared<rclcpp::Node>("ways");
  int heard = 0;
  auto publisher = node->create_publisher<Int32>("numbers", 10);
  auto subscription = node->create_subscription<Int32>(
    "numbers", 10, [&](Int32::ConstSharedPtr) {++heard;});
  ExecutorT executor;
  executor.add_node(node);
  std::string text;
  for (int i = 0; i < 5; ++i) {publisher->publish(Int32());}
  executor.spin_once();
  text += std::to_string(heard);
  executor.spin_some();
  text += std::to_string(heard);
  executor.spin_all(1s);
  text += std::to_string(heard);
  const auto begin = node->now();
  executor.spin_once(20ms);
  text += node->now() - begin >= rclcpp::Duration(20ms) ? " waited" : " did not wait";
  std::promise<void> never;
  text += " " + rclcpp::to_string(executor.spin_until_future_complete(never.get_future(), 5ms));
  const auto fails = [&text](auto && call) {
      try {
        call();
      } catch (const std::exception & error) {
        text += std::string("; ") + error.what();
      }
    };
  fails([&] {rclcpp::spin_some(node);});
  fails([&] {executor.spin_all(-1s);});
  auto timer = node->create_wall_timer(
    1ms, [&] {
      fails([&] {executor.spin();});
      executor.cancel();
    });
  executor.spin();
  executor.remove_node(node);
  fails([&] {executor.remove_node(node);});
  std::printf("%s: %s\n", name, text.c_str());
}

void contexts()
{
  auto context = std::make_shared<rclcpp::Context>();
  const char * arguments[] = {"program", "--ros-args", "-r", "__node:=renamed"};
  context->init(4, arguments);
  auto node = std::make_shared<rclcpp::Node>("named", rclcpp::NodeOptions().context(context));
  auto other = std::make_shared<rclcpp::Node>("named");
  std::string order;
  context->add_pre_shutdown_callback([&] {order += rclcpp::ok(context) ? "before " : "late ";});
  context->on_shutdown([&] {order += rclcpp::ok(context) ? "early" : "after";});
  std::thread spinner([&] {rclcpp::spin(node);});
  rclcpp::shutdown(context, "enough");
  spinner.join();
  std::printf(
    "contexts %s %s: %s, %s, still %d\n", node->get_name(), other->get_name(), order.c_str(),
    context->shutdown_reason().c_str(), rclcpp::ok());
}

/// An executor of its author, which takes what is ready one by one and tells what it is.
class Telling : public rclcpp::Executor
{
public:
  void spin() override
  {
    if (spinning.exchange(true)) {throw std::runtime_error("spinning already");}
    RCPPUTILS_SCOPE_EXIT(spinning = false;);
    while (rclcpp::ok(context_) && spinning.load()) {
      rclcpp::AnyExecutable next;
      if (!get_next_executable(next)) {continue;}
      text += next.timer ? "timer" : next.subscription ? next.subscription->get_topic_name() : "?";
      text += next.callback_group->can_be_taken_from() ? " free" : " alone";
      text += std::string(" of ") + next.node_base->get_name() + ", ";
      execute_any_executable(next);
    }
  }

  std::string text;
};

/// Wait sets are one template.
template<class SynchronizationT, class StorageT>
std::size_t size_of(rclcpp::WaitSetTemplate<SynchronizationT, StorageT> & wait_set)
{
  const auto result = wait_set.wait(0s);
  const bool over = result.kind() == rclcpp::WaitResultKind::Timeout;
  return over ? wait_set.get_rcl_wait_set().size_of_subscriptions : 100;
}

void tell()
{
  auto node = std::make_shared<rclcpp::Node>("telling");
  auto publisher = node->create_publisher<Int32>("told", 1);
  auto both = node->create_callback_group(rclcpp::CallbackGroupType::Reentrant);
  rclcpp::SubscriptionOptions options;
  options.callback_group = both;
  Telling executor;
  auto subscription = node->create_subscription<Int32>(
    "told", 1, [&](const Int32 &) {executor.cancel();}, options);
  rclcpp::TimerBase::SharedPtr timer;
  timer = node->create_wall_timer(
    1ms, [&] {
      timer->cancel();
      publisher->publish(Int32());
    });
  executor.add_node(node);
  executor.spin();
  rclcpp::ThreadSafeWaitSet safe({{subscription}});
  using Sizes = rclcpp::wait_set_policies::StaticStorage<1, 0, 0, 0, 0, 0>;
  rclcpp::WaitSetTemplate<rclcpp::wait_set_policies::SequentialSynchronization, Sizes> fixed(
    {{{subscription}}});
  std::printf("told %s%zu, %zu\n", executor.text.c_str(), size_of(safe), size_of(fixed));
}

void guard()
{
  rclcpp::GuardCondition condition;
  std::size_t calls = 0;
  condition.trigger();
  condition.trigger();
  condition.set_on_trigger_callback([&](std::size_t count) {calls += count;});
  condition.trigger();
  std::printf("guard %zu\n", calls);
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  overlap(rclcpp::CallbackGroupType::MutuallyExclusive, true);
  overlap(rclcpp::CallbackGroupType::MutuallyExclusive, false);
  overlap(rclcpp::CallbackGroupType::Reentrant, true);
  call_inside();
  own_executor();
  ways_to_spin<rclcpp::executors::SingleThreadedExecutor>("single");
  ways_to_spin<rclcpp::executors::StaticSingleThreadedExecutor>("static");
  ways_to_spin<rclcpp::experimental::executors::EventsExecutor>("events");
  contexts();
  guard();
  tell();
  rclcpp::shutdown();
  std::puts("done");
}
