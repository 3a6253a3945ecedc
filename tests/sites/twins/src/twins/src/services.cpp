#include <chrono>
#include <functional>
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/set_bool.hpp"
#include "std_srvs/srv/trigger.hpp"
#include "twins.hpp"

using namespace std::chrono_literals;
using std_msgs::msg::String;
using std_srvs::srv::SetBool;
using std_srvs::srv::Trigger;

static void attempt(const std::string & what, const std::function<void()> & act)
{
  try {
    act();
    say(what, "taken");
  } catch (const std::exception &) {
    say(what, "refused");
  }
}

void play_services()
{
  auto server = std::make_shared<rclcpp::Node>("server");
  auto asker = std::make_shared<rclcpp::Node>("asker", "robot");
  say(server->get_fully_qualified_name(), asker->get_fully_qualified_name());
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(server);
  executor.add_node(asker);

  auto service = server->create_service<SetBool>(
    "flip", [](const SetBool::Request::SharedPtr request, SetBool::Response::SharedPtr response) {
      response->success = !request->data;
      response->message = std::string("was ") + (request->data ? "true" : "false");
    });
  auto own = server->create_service<Trigger>(
    "~/own", [](const Trigger::Request::SharedPtr, Trigger::Response::SharedPtr response) {
      response->success = true;
    });
  auto client = asker->create_client<SetBool>("flip");
  auto nobody = asker->create_client<Trigger>("nobody");
  say(service->get_service_name(), own->get_service_name(), client->get_service_name());
  say("nobody", nobody->wait_for_service(100ms), nobody->service_is_ready());
  say("there", client->wait_for_service(10s), client->service_is_ready());
  const auto request = [](bool data) {
      auto made = std::make_shared<SetBool::Request>();
      made->data = data;
      return made;
    };
  for (const bool value : {true, false}) {
    auto future = client->async_send_request(request(value));
    executor.spin_until_future_complete(future);
    const auto response = future.get();
    say(response->success, response->message);
  }
  auto lost = nobody->async_send_request(std::make_shared<Trigger::Request>());
  say(
    "lost",
    executor.spin_until_future_complete(lost, 200ms) == rclcpp::FutureReturnCode::SUCCESS);
  std::vector<std::string> order;
  for (int i = 0; i < 4; ++i) {
    client->async_send_request(
      request(i % 2), [&order, i](rclcpp::Client<SetBool>::SharedFuture future) {
        order.push_back(std::to_string(i) + (future.get()->success ? ":True" : ":False"));
      });
  }
  while (order.size() < 4) {executor.spin_once(50ms);}
  say(order);
  for (const auto & [name, types] : asker->get_service_names_and_types()) {
    if (name == "/robot/toggle" || name == "/robot/mine") {say(name, types);}
  }
  service.reset();
  while (client->service_is_ready()) {executor.spin_once(50ms);}
  say("gone", client->wait_for_service(100ms));

  // Names
  const auto topic = [&](const std::string & name) {
      return std::string(asker->create_publisher<String>(name, 10)->get_topic_name());
    };
  say(topic("chatter"), topic("/a/b"));
  say(topic("~/private"));
  const auto topics = asker->get_node_topics_interface();
  const auto services = asker->get_node_services_interface();
  say(topics->resolve_topic_name("x/y"), services->resolve_service_name("flip"));
  for (const auto name :
    {"a b", "1a", "a//b", "/a/", "~a", "", "{node}/x", "{nobody}/x", "a__b"})
  {
    attempt(std::string("topic '") + name + "'", [&] {topic(name);});
  }
  for (const auto name : {"a b", "1a", "a-b", "", "_a"}) {
    attempt(std::string("node '") + name + "'", [&] {rclcpp::Node node(name);});
  }
  for (const auto space : {"/a b", "a", "/a/", "/1"}) {
    attempt(std::string("namespace '") + space + "'", [&] {rclcpp::Node node("n", space);});
  }
}
