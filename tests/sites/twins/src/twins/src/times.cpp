#include <chrono>
#include <functional>
#include <limits>
#include <memory>
#include <string>

#include "rcl_interfaces/msg/log.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rosgraph_msgs/msg/clock.hpp"
#include "twins.hpp"

using namespace std::chrono_literals;
using rclcpp::Duration;
using rclcpp::Time;

static void attempt(const std::string & what, const std::function<void()> & act)
{
  try {
    act();
    say(what, "done");
  } catch (const std::exception &) {
    say(what, "refused");
  }
}

static Duration seconds(std::int32_t whole) {return Duration(whole, 0);}

void play_times()
{
  // Arithmetic
  const Time three(3, 0), one(1, 500);
  say((three - one).nanoseconds(), (three + seconds(2)).nanoseconds());
  say((one - Duration(0, 500)).nanoseconds(), three > one, three == Time(3, 0));
  const Time ros(3, 0, RCL_ROS_TIME);
  attempt("less", [&] {(void)(three < ros);});
  attempt("minus", [&] {(void)(three - ros);});
  attempt("negative", [&] {Time(-1, 0);});
  attempt(
    "large", [&] {(void)(Time(std::numeric_limits<std::int64_t>::max()) + seconds(1));});
  say((seconds(-2) + Duration(0, 5)).nanoseconds(), seconds(1) > seconds(-1));
  const builtin_interfaces::msg::Time stamp = Time(5, 7);
  say(stamp.sec, stamp.nanosec, Time(stamp).nanoseconds());
  const builtin_interfaces::msg::Duration span = Duration(std::chrono::nanoseconds(-1000000001));
  say(span.sec, span.nanosec);

  // A clock that is simulated
  auto node = std::make_shared<rclcpp::Node>("times");
  auto clock = node->get_clock();
  say(
    clock->get_clock_type() == RCL_ROS_TIME, clock->ros_time_is_active(),
    clock->now().nanoseconds() > 0);
  node->set_parameter({"use_sim_time", true});
  say(clock->ros_time_is_active(), clock->now().nanoseconds());
  std::size_t fired = 0;
  rclcpp::TimerBase::SharedPtr timer = node->create_timer(1s, [&] {fired += 1;});
  rclcpp::TimerBase::SharedPtr wall = node->create_wall_timer(20ms, [] {});
  auto publisher = node->create_publisher<rosgraph_msgs::msg::Clock>("/clock", 10);
  while (!publisher->get_subscription_count()) {rclcpp::sleep_for(10ms);}
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  const auto tick = [&](std::int64_t milliseconds) {
      rosgraph_msgs::msg::Clock message;
      message.clock = Time(milliseconds * 1000000);
      publisher->publish(message);
      while (clock->now().nanoseconds() != milliseconds * 1000000) {executor.spin_once(50ms);}
      for (int i = 0; i < 5; ++i) {executor.spin_once(50ms);}
      const auto until = timer->time_until_trigger().count();
      say("tick", milliseconds, fired, timer->is_canceled() ? "canceled" : std::to_string(until));
    };
  for (const int milliseconds : {500, 1000, 1500, 2000, 2100}) {tick(milliseconds);}
  say(timer->time_until_trigger().count(), timer->is_ready(), timer->is_canceled());
  timer->cancel();
  say(timer->is_canceled());
  tick(3500);
  timer->reset();
  tick(4400);
  tick(4600);
  // Back by little, by much, and exactly to the time of a call.
  for (const int milliseconds : {4300, 5200, 5300, 1000, 1900, 2000, 9000, 8500, 9700}) {
    tick(milliseconds);
  }
  node->set_parameter({"use_sim_time", false});
  say(clock->ros_time_is_active(), timer->time_until_trigger() < 500ms);
  auto late = std::make_shared<rclcpp::Node>("late");
  auto later = late->create_timer(1s, [] {});
  late->set_parameter({"use_sim_time", true});
  while (!late->now().nanoseconds()) {
    rosgraph_msgs::msg::Clock message;
    message.clock = Time(7, 0);
    publisher->publish(message);
    rclcpp::spin_some(late);
  }
  say(later->time_until_trigger().count());
  late.reset();
  timer.reset();
  wall.reset();

  // Timers and rates
  int count = 0;
  timer = node->create_wall_timer(10ms, [&] {count += 1;});
  while (count < 3) {executor.spin_once(1s);}
  timer->cancel();
  for (int i = 0; i < 3; ++i) {executor.spin_once(20ms);}
  say("timer", count, 10000000);

  // The log
  std::vector<rcl_interfaces::msg::Log> lines;
  auto subscription = node->create_subscription<rcl_interfaces::msg::Log>(
    "/rosout", 100, [&](const rcl_interfaces::msg::Log & line) {lines.push_back(line);});
  while (node->count_publishers("/rosout") < 1) {executor.spin_once(50ms);}
  auto logger = node->get_logger();
  auto child = logger.get_child("part");
  RCLCPP_INFO(logger, "first");
  RCLCPP_DEBUG(logger, "not shown");
  for (int i = 0; i < 3; ++i) {RCLCPP_WARN_ONCE(logger, "once %d", i);}
  for (int i = 0; i < 3; ++i) {RCLCPP_ERROR_SKIPFIRST(logger, "skipped %d", i);}
  for (int i = 0; i < 3; ++i) {
    RCLCPP_WARN_THROTTLE(logger, *clock, 60000, "throttled %d", i);
  }
  RCLCPP_FATAL(child, "of the child");
  logger.set_level(rclcpp::Logger::Level::Warn);
  RCLCPP_INFO(logger, "not shown either");
  say(child.get_effective_level() <= rclcpp::Logger::Level::Info);
  logger.set_level(rclcpp::Logger::Level::Debug);
  RCLCPP_DEBUG(logger, "last");
  while (lines.empty() || lines.back().msg != "last") {executor.spin_once(50ms);}
  for (const auto & line : lines) {say(line.name, int(line.level), line.msg);}
}
