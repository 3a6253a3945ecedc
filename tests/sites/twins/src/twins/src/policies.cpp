#include <chrono>
#include <functional>
#include <memory>
#include <set>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_msgs/msg/u_int8.hpp"
#include "twins.hpp"

using namespace std::chrono_literals;
using std_msgs::msg::String;
using std_msgs::msg::UInt8;

namespace
{

std::vector<std::string> told;

void tell(const std::string & what, const std::vector<int> & numbers)
{
  std::string line = what;
  for (const int number : numbers) {line += " " + std::to_string(number);}
  told.push_back(line);
}

void ignore(String::ConstSharedPtr) {}

}  // namespace

void play_policies()
{
  auto node = std::make_shared<rclcpp::Node>("policies");
  const auto turn = [&](const std::function<bool()> & until) {
      rclcpp::executors::SingleThreadedExecutor executor;
      executor.add_node(node);
      while (!until()) {executor.spin_once(50ms);}
      auto lines = told;
      std::sort(lines.begin(), lines.end());
      told.clear();
      return lines;
    };
  const auto any = [] {return !told.empty();};
  const auto both = [] {return told.size() >= 2;};

  // Who comes late gets the last ones.
  std::vector<std::string> heard;
  const auto kept = rclcpp::QoS(2).transient_local();
  auto early = node->create_publisher<UInt8>("kept", kept);
  for (const int value : {1, 2, 3}) {
    UInt8 message;
    message.data = value;
    early->publish(message);
  }
  auto joiner = node->create_subscription<UInt8>(
    "kept", kept, [&](const UInt8 & message) {heard.push_back(std::to_string(message.data));});
  turn([&] {return heard.size() >= 2;});
  say("kept", heard);

  // What does not fit is told on both sides.
  const rclcpp::QoS reliable(1);
  const auto weak = rclcpp::QoS(1).best_effort();
  const auto slow = rclcpp::QoS(1).deadline(2s);
  const auto fast = rclcpp::QoS(1).deadline(1s);
  const auto by_topic = rclcpp::QoS(1).liveliness(
    rclcpp::LivelinessPolicy::ManualByTopic).liveliness_lease_duration(1s);
  const auto automatic = rclcpp::QoS(1).liveliness(
    rclcpp::LivelinessPolicy::Automatic).liveliness_lease_duration(1s);
  const std::vector<std::pair<rclcpp::QoS, rclcpp::QoS>> kPairs = {
    {weak, reliable}, {reliable, kept}, {slow, fast}, {automatic, by_topic}};
  int number = 0;
  for (const auto & [offered, requested] : kPairs) {
    const auto topic = "strict" + std::to_string(number++);
    rclcpp::PublisherOptions ours;
    ours.event_callbacks.incompatible_qos_callback =
      [](rclcpp::QOSOfferedIncompatibleQoSInfo & event) {
        tell("offered", {event.total_count, event.total_count_change, event.last_policy_kind});
      };
    rclcpp::SubscriptionOptions theirs;
    theirs.event_callbacks.incompatible_qos_callback =
      [](rclcpp::QOSRequestedIncompatibleQoSInfo & event) {
        tell("requested", {event.total_count, event.total_count_change, event.last_policy_kind});
      };
    auto publisher = node->create_publisher<String>(topic, offered, ours);
    auto subscription = node->create_subscription<String>(topic, requested, ignore, theirs);
    say(turn(both), publisher->get_subscription_count());
  }
  for (const auto & [one, two] : std::vector<std::pair<rclcpp::QoS, rclcpp::QoS>>{
      {rclcpp::SensorDataQoS(), kept}, {kept, reliable}, {slow, fast}})
  {
    say("compatible", int(rclcpp::qos_check_compatible(one, two).compatibility));
  }

  // Matched, and parted.
  rclcpp::PublisherOptions ours;
  ours.event_callbacks.matched_callback = [](rclcpp::MatchedInfo & event) {
      tell(
        "publisher", {int(event.total_count), int(event.total_count_change),
          int(event.current_count), event.current_count_change});
    };
  auto meeting = node->create_publisher<String>("meeting", 1, ours);
  auto first = node->create_subscription<String>("meeting", 1, ignore);
  say(turn(any));
  auto second = node->create_subscription<String>("meeting", 1, ignore);
  say(turn(any));
  first.reset();
  say(turn(any));
  second.reset();
  say(turn(any));

  // Too late, and not alive any more.
  {
    const auto late = rclcpp::QoS(1).deadline(100ms);
    rclcpp::PublisherOptions options;
    options.event_callbacks.deadline_callback =
      [](rclcpp::QOSDeadlineOfferedInfo &) {told.push_back("offered deadline");};
    rclcpp::SubscriptionOptions theirs;
    theirs.event_callbacks.deadline_callback =
      [](rclcpp::QOSDeadlineRequestedInfo &) {told.push_back("requested deadline");};
    auto publisher = node->create_publisher<String>("late", late, options);
    auto subscription = node->create_subscription<String>("late", late, ignore, theirs);
    publisher->publish(String());
    const auto lines = turn(
      [] {return std::set<std::string>(told.begin(), told.end()).size() == 2;});
    const std::set<std::string> different(lines.begin(), lines.end());
    say(std::vector<std::string>(different.begin(), different.end()));
  }
  const auto manual = rclcpp::QoS(1).liveliness(
    rclcpp::LivelinessPolicy::ManualByTopic).liveliness_lease_duration(200ms);
  rclcpp::PublisherOptions options;
  options.event_callbacks.liveliness_callback = [](rclcpp::QOSLivelinessLostInfo & event) {
      tell("lost", {event.total_count, event.total_count_change});
    };
  rclcpp::SubscriptionOptions theirs;
  theirs.event_callbacks.liveliness_callback = [](rclcpp::QOSLivelinessChangedInfo & event) {
      told.push_back(
        "alive " + std::to_string(event.alive_count) + " not " +
        std::to_string(event.not_alive_count));
    };
  auto publisher = node->create_publisher<String>("alive", manual, options);
  auto subscription = node->create_subscription<String>("alive", manual, ignore, theirs);
  publisher->publish(String());
  say(turn(any));
  say(turn(both));
  if (!publisher->assert_liveliness()) {say("not asserted");}
  say(turn(any));
}
