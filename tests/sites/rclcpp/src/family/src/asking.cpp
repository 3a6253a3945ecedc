// What a program can find out about the graph, its services and its messages.
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "example_interfaces/srv/add_two_ints.hpp"
#include "rcl/rcl.h"
#include "rcl_interfaces/srv/set_logger_levels.hpp"
#include "rclcpp/node_interfaces/node_interfaces.hpp"
#include "rclcpp/rclcpp.hpp"
#include "statistics_msgs/msg/metrics_message.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;
using example_interfaces::srv::AddTwoInts;
using rcl_interfaces::srv::SetLoggerLevels;
using statistics_msgs::msg::MetricsMessage;
using std_msgs::msg::String;
// Upstream's nodes have no member of this name.
using SetParametersResult = std::string;

class Asking : public rclcpp::Node
{
public:
  Asking()
  : Node("asking", rclcpp::NodeOptions().enable_logger_service(true)) {}

  SetParametersResult answer() const {return "global";}
};

namespace interfaces = rclcpp::node_interfaces;

std::string describe(interfaces::NodeInterfaces<
    interfaces::NodeBaseInterface, interfaces::NodeLoggingInterface> node)
{
  return std::string(node.get_node_base_interface()->get_name()) + " " +
         node.get<interfaces::NodeLoggingInterface>()->get_logger_name();
}

void ask_about_the_graph(rclcpp::Node & node)
{
  auto other = rclcpp::Node::make_shared("other", "/deep");
  const auto event = node.get_graph_event();
  auto publisher = node.create_publisher<String>("words", rclcpp::QoS(3).transient_local().deadline(200ms));
  auto subscription = rclcpp::create_subscription<String>(
    other, "/words", rclcpp::SensorDataQoS().deadline(250ms), [](const String &) {});
  auto service = rclcpp::create_service<AddTwoInts>(
    other, "add", [](AddTwoInts::Request::SharedPtr, AddTwoInts::Response::SharedPtr) {});
  node.wait_for_graph_change(event, 10s);
  std::printf("changed %d, again %d\n", event->check_and_clear(), event->check());
  for (const auto & name : node.get_node_names()) {std::printf("node %s\n", name.c_str());}
  std::printf("words is %s\n", node.get_topic_names_and_types().at("/words").at(0).c_str());
  for (const auto & [name, types] : node.get_service_names_and_types_by_node("other", "/deep")) {
    if (name == "/deep/add") {std::printf("%s is %s\n", name.c_str(), types.at(0).c_str());}
  }
  std::printf(
    "counts %zu %zu %zu %zu, matched %zu\n", node.count_publishers("words"),
    node.count_subscribers("words"), node.count_services("/deep/add"), node.count_clients("none"),
    publisher->get_subscription_count());
  for (const auto & found : {
      node.get_publishers_info_by_topic("words").at(0),
      node.get_subscriptions_info_by_topic("rt/words", true).at(0)})
  {
    const auto & qos = found.qos_profile();
    std::printf(
      "%s in %s: %s, kind %d, reliable %d, kept %d, deadline %.2f\n", found.node_name().c_str(),
      found.node_namespace().c_str(), found.topic_type().c_str(),
      static_cast<int>(found.endpoint_type()),
      qos.reliability() == rclcpp::ReliabilityPolicy::Reliable,
      qos.durability() == rclcpp::DurabilityPolicy::TransientLocal,
      qos.deadline().nanoseconds() == INT64_MAX ? 0 : qos.deadline().seconds());
  }
  const auto gid = publisher->get_gid();
  const auto told = node.get_publishers_info_by_topic("words").at(0).endpoint_gid();
  std::printf("the same gid %d\n", std::equal(told.begin(), told.end(), gid.data));
  try {
    node.get_service_names_and_types_by_node("nobody", "/");
  } catch (const rclcpp::exceptions::RCLError & error) {
    std::printf("refused: %s\n", error.what());
  }
}

void look_into_a_service(const rclcpp::Node::SharedPtr & node)
{
  // As programs for Humble write it.
  auto service = rclcpp::create_service<AddTwoInts>(
    node->get_node_base_interface(), node->get_node_services_interface(), "add",
    [](AddTwoInts::Request::SharedPtr ask, AddTwoInts::Response::SharedPtr answer) {
      answer->sum = ask->a + ask->b;
    }, rmw_qos_profile_services_default, nullptr);
  auto client = rclcpp::create_client<AddTwoInts>(
    node->get_node_base_interface(), node->get_node_graph_interface(),
    node->get_node_services_interface(), "add", rmw_qos_profile_services_default);
  const auto clock = node->get_clock();
  service->configure_introspection(clock, rclcpp::QoS(10), RCL_SERVICE_INTROSPECTION_METADATA);
  client->configure_introspection(clock, rclcpp::QoS(10), RCL_SERVICE_INTROSPECTION_CONTENTS);
  std::vector<AddTwoInts::Event> events;
  auto spy = node->create_subscription<AddTwoInts::Event>(
    "add/_service_event", 10, [&](const AddTwoInts::Event & event) {events.push_back(event);});
  auto request = std::make_shared<AddTwoInts::Request>();
  request->a = 2;
  request->b = 3;
  while (!client->wait_for_service(1s) || spy->get_publisher_count() < 2) {}
  auto future = client->async_send_request(request);
  while (events.size() < 4) {rclcpp::spin_some(node);}
  for (const auto kind : {0, 1, 2, 3}) {
    for (const auto & event : events) {
      if (event.info.event_type != kind) {continue;}
      std::printf(
        "event %d of request %d, asked %d, answered %d\n", kind,
        static_cast<int>(event.info.sequence_number),
        event.request.empty() ? -1 : static_cast<int>(event.request[0].b),
        event.response.empty() ? -1 : static_cast<int>(event.response[0].sum));
    }
  }
  const bool same = events[0].info.client_gid == events[1].info.client_gid;
  std::printf("one client %d, sum %d\n", same, static_cast<int>(future.get()->sum));
}

void gather_statistics(const rclcpp::Node::SharedPtr & node)
{
  rclcpp::SubscriptionOptions options;
  options.topic_stats_options.state = rclcpp::TopicStatisticsState::Enable;
  options.topic_stats_options.publish_period = 300ms;
  options.topic_stats_options.publish_topic = "numbers";
  auto publisher = node->create_publisher<String>("beat", 10);
  auto subscription = node->create_subscription<String>("beat", 10, [](const String &) {}, options);
  std::vector<MetricsMessage> heard;
  auto listener = node->create_subscription<MetricsMessage>(
    "numbers", 10, [&](const MetricsMessage & message) {heard.push_back(message);});
  while (publisher->get_subscription_count() == 0 || listener->get_publisher_count() == 0) {
    rclcpp::spin_some(node);
  }
  for (int i = 0; i < 3; ++i) {publisher->publish(String());}
  while (heard.size() < 2) {rclcpp::spin_some(node);}
  for (const auto & message : heard) {
    std::printf("%s of %s in %s:", message.metrics_source.c_str(),
      message.measurement_source_name.c_str(), message.unit.c_str());
    for (const auto & point : message.statistics) {
      const bool ordered = point.data >= 0 && point.data < 60000;
      if (point.data_type == 5) {std::printf(" count %.0f", point.data);}
      if (point.data_type != 5) {std::printf(" %d", ordered);}
    }
    std::printf("\n");
  }
}

/// Services and clients of a type that only the program knows when it runs.
void ask_by_name(const rclcpp::Node::SharedPtr & node)
{
  const char * type = "example_interfaces/srv/AddTwoInts";
  const auto sum = [](const std::shared_ptr<void> & message) -> auto & {
      return static_cast<AddTwoInts::Response *>(message.get())->sum;
    };
  auto add = node->create_generic_service(
    "named", type, [&](std::shared_ptr<void> request, std::shared_ptr<void> response) {
      const auto * numbers = static_cast<AddTwoInts::Request *>(request.get());
      sum(response) = numbers->a + numbers->b;
    });
  auto later = node->create_generic_service(
    "later", type,
    [&](
      std::shared_ptr<rclcpp::GenericService> self, std::shared_ptr<rmw_request_id_t> id,
      std::shared_ptr<void>) {
      auto response = self->create_response();
      sum(response) = -1;
      self->send_response(*id, response);
    });
  rclcpp::GenericClient::SharedPtr client = node->create_generic_client("named", type);
  auto other = rclcpp::create_generic_client(node, "later", type);
  client->wait_for_service();
  other->wait_for_service();
  AddTwoInts::Request request;
  request.a = 2;
  request.b = 3;
  auto answer = client->async_send_request(&request);
  rclcpp::spin_until_future_complete(node, answer);
  std::printf("by name %d", static_cast<int>(sum(answer.get())));
  auto called = other->async_send_request(
    &request, [&](rclcpp::GenericClient::SharedFuture future) {
      std::printf(", later %d", static_cast<int>(sum(future.get())));
    });
  rclcpp::spin_until_future_complete(node, called);
  auto nobody = node->create_generic_client("nobody", type);
  const auto lost = nobody->async_send_request(&request);
  const bool removed = nobody->remove_pending_request(lost);
  std::printf(", removed %d %d\n", removed, nobody->remove_pending_request(lost.request_id));
  try {
    node->create_generic_client("unknown", "std_srvs/srv/Empty");
  } catch (const std::runtime_error & error) {
    std::printf("%s\n", error.what());
  }
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Asking>();
  std::printf("%s %s\n", node->answer().c_str(), describe(*node).c_str());
  ask_about_the_graph(*node);
  look_into_a_service(node);
  gather_statistics(node);
  ask_by_name(node);
  const auto flows = node->create_publisher<String>("flows", 1)->get_network_flow_endpoints();
  std::printf("flows %d\n", flows == std::vector<rclcpp::NetworkFlowEndpoint>());

  auto levels = node->create_client<SetLoggerLevels>("asking/set_logger_levels");
  auto request = std::make_shared<SetLoggerLevels::Request>();
  request->levels.resize(2);
  request->levels[0].name = "asking";
  request->levels[0].level = 40;
  request->levels[1].level = 41;
  auto answer = levels->async_send_request(request);
  rclcpp::spin_until_future_complete(node, answer);
  const auto results = answer.get()->results;
  std::printf(
    "level %d %d, now %d\n", results[0].successful, results[1].successful,
    static_cast<int>(node->get_logger().get_effective_level()));

  auto latched = node->create_publisher<String>("latched", rclcpp::QoS(1).transient_local());
  String word;
  word.data = "kept";
  latched->publish(word);
  String found;
  const bool came =
    rclcpp::wait_for_message(found, node, "latched", 10s, rclcpp::QoS(1).transient_local());
  std::printf("waited %d %s\n", came, found.data.c_str());

  rclcpp::PublisherOptions options;
  options.qos_overriding_options = rclcpp::QosOverridingOptions(
    {rclcpp::QosPolicyKind::Depth, rclcpp::QosPolicyKind::Reliability},
    [](const rclcpp::QoS & qos) {
      return rclcpp::QosCallbackResult{qos.depth() <= 10, "too deep"};
    });
  const auto changed = node->create_publisher<String>("changed", 1, options)->get_actual_qos();
  std::printf(
    "depth %zu, reliable %d\n", changed.depth(),
    changed.reliability() == rclcpp::ReliabilityPolicy::Reliable);
  const auto plain = rclcpp::SystemDefaultsQoS();
  const auto system = node->create_subscription<String>("plain", plain, [](const String &) {});
  const auto left = system->get_actual_qos();
  std::printf(
    "left to the system: %d %d %d %d\n",
    left.reliability() == rclcpp::ReliabilityPolicy::BestEffort,
    left.history() == rclcpp::HistoryPolicy::KeepLast,
    left.liveliness() == rclcpp::LivelinessPolicy::Automatic,
    left.deadline().nanoseconds() == INT64_MAX);
  try {
    node->create_publisher<String>("deep", 11, options);
  } catch (const rclcpp::exceptions::InvalidQosOverridesException & error) {
    std::printf("refused: %s\n", error.what());
  }
  rclcpp::shutdown();
}
