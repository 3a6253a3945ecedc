// Ends, or does not, in the way that its argument names.
#include <cassert>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;

namespace robot
{
struct BatteryError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};
}  // namespace robot

struct Robot
{
  int wheels = 2;
};

using NodePtr = rclcpp::Node::SharedPtr;

static volatile int zero = 0;

// Not touched, so that only the program runs out of memory and not the machine.
struct Block
{
  Block() {}
  char bytes[64 << 20];
};
static std::vector<std::unique_ptr<Block>> blocks;

static int deeper(int depth)
{
  volatile int here[4] = {depth};
  return zero == 0 ? deeper(depth + 1) + here[zero] : depth;
}

// Its frames fill the stack of the program before that of the browser.
static int wider(int depth)
{
  volatile char here[20'000];
  here[0] = static_cast<char>(depth);
  return zero == 0 ? wider(depth + 1) + here[zero] : depth;
}

static void roll(int wheel)
{
  if (wheel == 0) {throw std::invalid_argument("no wheel");}
}

static const std::map<std::string, void (*)(NodePtr)> kFaults = {
  {"throw", [](NodePtr) {throw robot::BatteryError("battery <b>low</b>");}},
  {"throw-in-callback", [](NodePtr node) {
      auto timer = node->create_wall_timer(20ms, []() {throw std::out_of_range("no such wheel");});
      rclcpp::spin(node);  // throws
    }},
  {"catch", [](NodePtr node) {
      auto timer = node->create_wall_timer(20ms, []() {throw std::runtime_error("a small thing");});
      try {
        rclcpp::spin(node);
      } catch (const std::exception & error) {
        RCLCPP_WARN(node->get_logger(), "caught: %s", error.what());
      }
    }},
  {"abort", [](NodePtr) {std::abort();}},
  {"assert", [](NodePtr) {assert(zero == 1);}},
  {"null", [](NodePtr) {
      const std::shared_ptr<Robot> nobody;
      nobody->wheels += 1;
    }},
  {"outside", [](NodePtr) {
      const std::vector<int> wheels(4);
      zero = wheels[4 + zero];
    }},
  {"library", [](NodePtr) {rclcpp::Node node("no name");}},
  {"thread", [](NodePtr) {std::thread([] {roll(zero);}).join();}},
  {"trap", [](NodePtr) {__builtin_trap();}},
  {"trap-after-wait", [](NodePtr) {
      std::this_thread::sleep_for(20ms);
      __builtin_trap();
    }},
  {"exit", [](NodePtr) {std::exit(3);}},
  {"busy", [](NodePtr node) {
      RCLCPP_INFO(node->get_logger(), "busy");
      while (zero == 0) {}
    }},
  {"out-of-memory", [](NodePtr) {
      for (;;) {blocks.push_back(std::make_unique<Block>());}
    }},
  {"recursion", [](NodePtr) {zero = deeper(0);}},
  {"large-frames", [](NodePtr) {zero = wider(0);}},
  {"large-variable", [](NodePtr) {
      volatile char points[4'000'000];
      points[zero] = 1;
    }},
  {"pour", [](NodePtr node) {
      auto publisher = node->create_publisher<std_msgs::msg::String>("/large", 10);
      std_msgs::msg::String message;
      for (char filling = 'a';; filling = filling == 'z' ? 'a' : filling + 1) {
        message.data.assign(4'000'000, filling);
        publisher->publish(message);
        std::this_thread::sleep_for(1ms);
      }
    }},
  {"drink", [](NodePtr node) {
      auto subscription = node->create_subscription<std_msgs::msg::String>(
        "/large", 10, [node](const std_msgs::msg::String & message) {
          const auto whole = message.data.size() == 4'000'000 &&
          message.data.find_first_not_of(message.data[0]) == std::string::npos;
          RCLCPP_INFO(node->get_logger(), "a large message, %s", whole ? "whole" : "torn");
        });
      rclcpp::spin(node);
    }},
  {"last-words", [](NodePtr node) {
      auto publisher = node->create_publisher<std_msgs::msg::String>("/words", rclcpp::QoS(300));
      while (publisher->get_subscription_count() == 0) {std::this_thread::sleep_for(10ms);}
      for (int i = 1; i <= 300; ++i) {
        std_msgs::msg::String message;
        message.data = std::to_string(i);
        publisher->publish(message);
      }
    }},
  {"listen", [](NodePtr node) {
      int count = 0;
      auto subscription = node->create_subscription<std_msgs::msg::String>(
        "/words", rclcpp::QoS(300), [&](const std_msgs::msg::String & message) {
          count += 1;
          if (message.data == "300") {RCLCPP_INFO(node->get_logger(), "heard %d words", count);}
        });
      rclcpp::spin(node);
    }},
  {"sleep", [](NodePtr node) {
      const auto begin = node->now();
      std::this_thread::sleep_for(300ms);
      const auto slept = (node->now() - begin).seconds();
      std::cout << "slept " << (slept >= 0.3 && slept < 30) << std::endl;
      std::printf("no newline at the end");
    }},
  {"steps", [](NodePtr node) {
      auto future = std::promise<int>();
      auto timer = node->create_wall_timer(50ms, [&]() {future.set_value(7); throw 1;});
      try {
        rclcpp::spin_until_future_complete(node, future.get_future().share());
      } catch (int) {
      }
      RCLCPP_INFO(node->get_logger(), "never waited for anything else");
      std::promise<int> never;
      const auto result = rclcpp::spin_until_future_complete(
        rclcpp::Node::make_shared("other"), never.get_future().share(), 30ms);
      RCLCPP_ERROR(
        node->get_logger(), "timeout: %d", result == rclcpp::FutureReturnCode::TIMEOUT);
    }},
  {"flood", [](NodePtr node) {
      for (int i = 0; i < 100000; ++i) {std::cout << "line " << i << "\n";}
      std::cout << std::flush;
      rclcpp::spin(node);
    }},
  {"levels", [](NodePtr node) {
      auto logger = node->get_logger();
      RCLCPP_DEBUG(logger, "not shown");
      logger.set_level(rclcpp::Logger::Level::Debug);
      RCLCPP_DEBUG(logger, "%s %5.2f %ld %zu %x %c %%", "shown", 3.14159, INT64_C(-5000000000),
        sizeof(int), 255u, 'z');
      RCLCPP_FATAL_STREAM(logger, "stream " << 1 << ' ' << true);
      for (int i = 0; i < 3; ++i) {RCLCPP_INFO_ONCE(logger, "once %d", i);}
      for (int i = 0; i < 3; ++i) {RCLCPP_INFO_SKIPFIRST(logger, "skipped first %d", i);}
      for (int i = 0; i < 3; ++i) {
        RCLCPP_WARN_THROTTLE(logger, *node->get_clock(), 60000, "throttled %d", i);
      }
    }},
};

int main(int argc, char ** argv)
{
  const auto arguments = rclcpp::init_and_remove_ros_arguments(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("fault");
  auto publisher = node->create_publisher<std_msgs::msg::String>("~/status", 10);
  kFaults.at(arguments.at(1))(node);
  // As programs do that count an interrupt as a failure.
  return rclcpp::ok() ? 0 : 1;
}
