// Parameters: declared, overridden, checked, watched, and read by another node.
#include <chrono>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "rosgraph_msgs/msg/clock.hpp"

using namespace std::chrono_literals;
using rcl_interfaces::msg::ParameterDescriptor;
using rcl_interfaces::msg::SetParametersResult;

class Robot : public rclcpp::Node
{
public:
  Robot()
  : Node("robot")
  {
    declare_parameter("speed", 1.5);
    declare_parameter("name", "r2");
    declare_parameter<int>("wheels", 4);
    declare_parameter("list", std::vector<std::int64_t>{1, 2});
    declare_parameter("arm.joints", 6);
    ParameterDescriptor range;
    range.integer_range.resize(1);
    range.integer_range[0].from_value = 0;
    range.integer_range[0].to_value = 10;
    range.integer_range[0].step = 2;
    declare_parameter("even", 4, range);
    ParameterDescriptor fixed;
    fixed.read_only = true;
    declare_parameter("serial", "A1", fixed);
    ParameterDescriptor dynamic;
    dynamic.dynamic_typing = true;
    declare_parameter("any", rclcpp::ParameterValue(), dynamic);
    check_ = add_on_set_parameters_callback([](const std::vector<rclcpp::Parameter> & changes) {
          SetParametersResult result;
          result.successful = true;
          for (const auto & change : changes) {
            if (change.get_name() == "speed" && change.as_double() > 10) {
              result.successful = false;
              result.reason = "too fast";
            }
          }
          return result;
        });
    after_ = add_post_set_parameters_callback([this](const std::vector<rclcpp::Parameter> & changes) {
          for (const auto & change : changes) {
            std::printf("set %s\n", std::to_string(change).c_str());
          }
        });
  }

private:
  OnSetParametersCallbackHandle::SharedPtr check_;
  PostSetParametersCallbackHandle::SharedPtr after_;
};

template<class Call>
void attempt(Call call)
{
  try {
    call();
  } catch (const std::exception & error) {
    std::printf("refused: %s\n", error.what());
  }
}

/// A node on a clock that stands still, jumps back, and becomes real.
void jump(const rclcpp::Node::SharedPtr & node, rclcpp::Publisher<rosgraph_msgs::msg::Clock> & out)
{
  const auto clock = node->get_clock();
  const auto show = [&](int second) {
      rosgraph_msgs::msg::Clock message;
      message.clock.sec = second;
      out.publish(message);
      while (clock->now().seconds() != second) {std::this_thread::sleep_for(1ms);}
    };
  std::printf("past %d\n", clock->sleep_until(rclcpp::Time(50, 0, RCL_ROS_TIME)));
  rclcpp::Rate rate(rclcpp::Duration(10, 0), clock);
  show(5);
  std::thread time([&] {
      for (int second = 6; second < 40; ++second) {show(second);}
    });
  const bool slept = rate.sleep();
  std::printf("rate %d %d\n", slept, clock->now().seconds() >= 15);
  time.join();
  std::printf("end %d\n", static_cast<int>(clock->now().seconds()));

  bool called = false;
  auto timer = node->create_timer(20ms, [&] {called = true;});
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  std::thread spinner([&] {executor.spin();});
  bool whole = true;
  std::thread sleeper([&] {whole = clock->sleep_for(rclcpp::Duration(3600, 0));});
  for (bool simulated = false; whole; simulated = !simulated) {
    node->set_parameter({"use_sim_time", simulated});
    std::this_thread::sleep_for(1ms);
  }
  node->set_parameter({"use_sim_time", false});
  while (!called) {std::this_thread::sleep_for(1ms);}
  sleeper.join();
  executor.cancel();
  spinner.join();
  std::puts("became real");
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto robot = std::make_shared<Robot>();
  std::printf(
    "%s %s %s %s %s\n", robot->get_parameter("speed").value_to_string().c_str(),
    robot->get_parameter("name").as_string().c_str(),
    robot->get_parameter("wheels").value_to_string().c_str(),
    robot->get_parameter("list").value_to_string().c_str(),
    robot->get_parameter("even").value_to_string().c_str());

  attempt([&] {robot->get_parameter("nothing");});
  attempt([&] {robot->declare_parameter("speed", 1.0);});
  attempt([&] {robot->set_parameter(rclcpp::Parameter("nothing", 1));});
  attempt([&] {robot->get_parameter("name").as_int();});
  attempt([&] {robot->undeclare_parameter("serial");});
  attempt([&] {robot->undeclare_parameter("speed");});
  attempt([&] {robot->declare_parameter<double>("unset");});
  attempt([&] {robot->declare_parameter("typed", rclcpp::PARAMETER_INTEGER);});
  attempt([&] {robot->get_parameter("typed");});
  for (const auto & result : robot->set_parameters({
      rclcpp::Parameter("speed", 11.0), rclcpp::Parameter("speed", "fast"),
      rclcpp::Parameter("even", 3), rclcpp::Parameter("serial", "B"),
      rclcpp::Parameter("any", true), rclcpp::Parameter("any", "text")}))
  {
    std::printf("%d %s\n", result.successful, result.reason.c_str());
  }
  double speed = 0;
  std::string other;
  std::printf(
    "or %d %.1f %d %s\n", robot->get_parameter("speed", speed), speed,
    robot->get_parameter_or("other", other, std::string("else")), other.c_str());
  std::map<std::string, std::int64_t> arm;
  robot->get_parameters("arm", arm);
  std::printf("arm %d\n", static_cast<int>(arm["joints"]));

  // Another node, over the services.
  auto reader = std::make_shared<rclcpp::Node>("reader");
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(robot);
  std::thread spinner([&] {executor.spin();});
  rclcpp::SyncParametersClient client(reader, "robot");
  while (!client.wait_for_service(1s)) {std::puts("waiting");}
  auto events = std::make_shared<rclcpp::ParameterEventHandler>(reader);
  int event = 0;
  std::string changed;
  auto handle = events->add_parameter_callback(
    "speed", [&](const rclcpp::Parameter & parameter) {
      ++event;
      changed = parameter.value_to_string();
    }, "robot");
  for (const auto & name : client.list_parameters({}, 10).names) {std::printf("%s ", name.c_str());}
  std::puts("");
  std::printf("%d %d\n", client.has_parameter("speed"), client.has_parameter("nothing"));
  std::printf(
    "%s %d\n", client.get_parameter<std::string>("name").c_str(),
    client.get_parameter<int>("nothing", 7));
  const auto results = client.set_parameters(
    {rclcpp::Parameter("speed", 2.5), rclcpp::Parameter("speed", 12.0),
      rclcpp::Parameter("nothing", 1)});
  for (const auto & result : results) {
    std::printf("%d %s\n", result.successful, result.reason.c_str());
  }
  const auto described = client.describe_parameters({"even", "serial"});
  std::printf(
    "%d %d\n", static_cast<int>(described[0].integer_range[0].to_value), described[1].read_only);
  while (!event) {rclcpp::spin_some(reader);}
  std::printf("event %s\n", changed.c_str());

  // Time of /clock.
  auto late = std::make_shared<rclcpp::Node>(
    "late", rclcpp::NodeOptions().append_parameter_override("use_sim_time", true));
  auto clock = reader->create_publisher<rosgraph_msgs::msg::Clock>("/clock", rclcpp::ClockQoS());
  while (!clock->get_subscription_count()) {std::this_thread::sleep_for(1ms);}
  std::printf("began %d\n", static_cast<int>(late->now().seconds()));
  int calls = 0;
  auto timer = late->create_timer(10s, [&] {++calls;});
  std::thread time([&] {
      for (int second = 1; second <= 100; ++second) {
        rosgraph_msgs::msg::Clock message;
        message.clock.sec = second;
        clock->publish(message);
        std::this_thread::sleep_for(1ms);
      }
    });
  late->get_clock()->sleep_until(rclcpp::Time(50, 0, RCL_ROS_TIME));
  std::printf("slept %d\n", late->now().seconds() >= 50);
  time.join();
  rclcpp::spin_some(late);
  std::printf("ended %d, calls %d\n", static_cast<int>(late->now().seconds()), calls);
  jump(late, *clock);
  executor.cancel();
  spinner.join();
  std::puts("done");
}
