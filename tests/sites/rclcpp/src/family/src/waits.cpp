// Wait sets: what is ready is found and taken, and nothing is called back by itself.
#include <chrono>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <thread>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp/wait_set.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;
using std_msgs::msg::String;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("waits");
  auto never = [](String::UniquePtr message) {std::printf("handled %s\n", message->data.c_str());};
  auto one = node->create_subscription<String>("one", 10, never);
  auto two = node->create_subscription<String>("two", 10, never);
  auto guard = std::make_shared<rclcpp::GuardCondition>();
  auto publisher = node->create_publisher<String>("one", 10);

  rclcpp::WaitSet empty;
  std::printf("empty %d\n", empty.wait(1s).kind() == rclcpp::WaitResultKind::Empty);

  rclcpp::WaitSet set({{one}, {two}}, {guard});
  std::printf("timeout %d\n", set.wait(10ms).kind() == rclcpp::WaitResultKind::Timeout);
  String message;
  message.data = "first";
  publisher->publish(message);
  auto result = set.wait(5s);
  const auto & ready = result.get_wait_set().get_rcl_wait_set();
  std::printf(
    "ready %d: %d %d\n", result.kind() == rclcpp::WaitResultKind::Ready,
    ready.subscriptions[0] != nullptr, ready.subscriptions[1] != nullptr);
  String taken;
  rclcpp::MessageInfo info;
  std::printf("took %d %s", one->take(taken, info), taken.data.c_str());
  std::printf(", no more %d\n", one->take(taken, info));

  publisher->publish(message);
  auto again = set.wait();
  if (auto subscription = again.next_ready_subscription()) {
    auto erased = subscription->create_message();
    rclcpp::MessageInfo of_it;
    if (subscription->take_type_erased(erased.get(), of_it)) {
      subscription->handle_message(erased, of_it);
    }
  }

  std::thread trigger([&] {
      std::this_thread::sleep_for(20ms);
      guard->trigger();
    });
  auto guarded = set.wait(5s);
  std::printf("guard %d\n", guarded.get_wait_set().get_rcl_wait_set().guard_conditions[0] != nullptr);
  trigger.join();

  rclcpp::StaticWaitSet<0, 0, 1, 0, 0, 0> timed({}, {}, {node->create_wall_timer(5ms, [] {
          std::puts("timer");
        })});
  if (auto timer = timed.wait().next_ready_timer()) {
    timer->execute_callback(timer->call());
  }
  try {
    set.add_guard_condition(guard);
  } catch (const std::runtime_error & error) {
    std::printf("%s\n", error.what());
  }
  std::thread stop([] {rclcpp::shutdown();});
  std::printf("stopped %d\n", set.wait(1h).kind() == rclcpp::WaitResultKind::Timeout);
  stop.join();
  publisher->publish(message);
  std::printf("still ready %d\n", set.wait(1s).kind() == rclcpp::WaitResultKind::Ready);
}
