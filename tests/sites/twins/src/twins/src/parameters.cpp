#include <chrono>
#include <functional>
#include <memory>
#include <set>

#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rcl_interfaces/srv/describe_parameters.hpp"
#include "rcl_interfaces/srv/get_parameters.hpp"
#include "rcl_interfaces/srv/list_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters.hpp"
#include "rclcpp/rclcpp.hpp"
#include "twins.hpp"

using namespace std::chrono_literals;
using rcl_interfaces::msg::ParameterDescriptor;
using rcl_interfaces::msg::ParameterEvent;
using rcl_interfaces::msg::SetParametersResult;
using rclcpp::Parameter;

namespace
{

using Words = std::vector<std::string>;

bool own(const std::string & name)
{
  static const Words kOwn = {"rate", "names", "fixed", "even", "arm.", "loose"};
  return std::any_of(
    kOwn.begin(), kOwn.end(), [&](const auto & each) {return name.rfind(each, 0) == 0;});
}

void attempt(const std::string & what, const std::function<void()> & act)
{
  try {
    act();
    say(what, "done");
  } catch (const rclcpp::exceptions::InvalidParameterTypeException &) {
    say(what, "wrong type");
  } catch (const rclcpp::exceptions::InvalidParameterValueException &) {
    say(what, "wrong value");
  } catch (const rclcpp::exceptions::ParameterAlreadyDeclaredException &) {
    say(what, "declared already");
  } catch (const rclcpp::exceptions::ParameterImmutableException &) {
    say(what, "immutable");
  } catch (const rclcpp::exceptions::ParameterNotDeclaredException &) {
    say(what, "not declared");
  }
}

template<typename Parameters>
Words names(const Parameters & parameters)
{
  Words found;
  for (const auto & each : parameters) {
    if constexpr (std::is_same_v<std::decay_t<decltype(each)>, Parameter>) {
      found.push_back(each.get_name());
    } else if (own(each.name)) {
      found.push_back(each.name);
    }
  }
  return found;
}

}  // namespace

void play_parameters()
{
  auto node = std::make_shared<rclcpp::Node>("configured");
  auto other = std::make_shared<rclcpp::Node>(
    "other", rclcpp::NodeOptions().start_parameter_event_publisher(false));
  std::vector<ParameterEvent> events;
  auto subscription = other->create_subscription<ParameterEvent>(
    "/parameter_events", 100, [&](const ParameterEvent & event) {events.push_back(event);});
  while (!other->count_publishers("/parameter_events")) {rclcpp::sleep_for(10ms);}

  // Declared
  ParameterDescriptor even, length, read_only, dynamic;
  even.description = "an even number";
  even.integer_range.resize(1);
  even.integer_range[0].to_value = 10;
  even.integer_range[0].step = 2;
  length.floating_point_range.resize(1);
  length.floating_point_range[0].from_value = 0.5;
  length.floating_point_range[0].to_value = 1.5;
  read_only.read_only = true;
  dynamic.dynamic_typing = true;
  node->declare_parameter("rate", 1.0);
  node->declare_parameter("names", Words{"x"});
  node->declare_parameter("fixed", 1, read_only);
  node->declare_parameter("even", 4, even);
  node->declare_parameter("arm.length", 1.0, length);
  node->declare_parameter("arm.joints", std::vector<std::int64_t>{1, 2, 3});
  node->declare_parameter("loose", rclcpp::ParameterValue(true), dynamic);
  attempt("again", [&] {node->declare_parameter("rate", 1.0);});
  attempt("word", [&] {node->declare_parameter("word", "text");});
  attempt("odd", [&] {node->declare_parameter("odd", 3, even);});
  attempt("nothing", [&] {node->get_parameter("nothing");});
  std::cout << "rate 2.50 " << (node->get_parameter("rate").as_double() == 2.5 ? "" : "not ");
  say(node->get_parameter("names").as_string_array());
  say("or", node->get_parameter_or("nobody", 5));
  std::map<std::string, Parameter> prefixed;
  node->get_node_parameters_interface()->get_parameters_by_prefix("arm", prefixed);
  Words found;
  for (const auto & each : prefixed) {found.push_back(each.first);}
  say("prefix", found);

  // Set
  auto before = node->add_pre_set_parameters_callback(
    [](std::vector<Parameter> & parameters) {say("before", names(parameters));});
  auto check = node->add_on_set_parameters_callback(
    [](const std::vector<Parameter> & parameters) {
      SetParametersResult result;
      result.successful = std::all_of(
        parameters.begin(), parameters.end(), [](const Parameter & each) {
          return each.get_name() != "rate" || each.as_double() < 10;
        });
      say("check", names(parameters));
      if (!result.successful) {result.reason = "too fast";}
      return result;
    });
  auto after = node->add_post_set_parameters_callback(
    [](const std::vector<Parameter> & parameters) {say("after", names(parameters));});
  for (const auto & each : std::vector<Parameter>{
      {"rate", 3.0}, {"rate", 30.0}, {"rate", "fast"}, {"fixed", 2}, {"even", 6}, {"even", 7},
      {"even", 12}, {"arm.length", 0.25}, {"arm.length", 1.25}, {"loose", 3}, {"loose", "x"}})
  {
    const auto result = node->set_parameter(each);
    say(each.get_name(), result.successful, result.reason == "too fast" ? result.reason : "");
  }
  attempt("nothing", [&] {node->set_parameter({"nothing", 1});});
  say("together", node->set_parameters_atomically({{"even", 8}, {"rate", 99.0}}).successful);
  say("even", node->get_parameter("even").as_int());
  say("together", node->set_parameters_atomically({{"even", 8}, {"rate", 9.0}}).successful);
  node->remove_on_set_parameters_callback(check.get());
  node->remove_pre_set_parameters_callback(before.get());
  node->remove_post_set_parameters_callback(after.get());
  say("fast", node->set_parameter({"rate", 50.0}).successful);

  // Taken back
  attempt("undeclare loose", [&] {node->undeclare_parameter("loose");});
  attempt("undeclare loose", [&] {node->undeclare_parameter("loose");});
  attempt("undeclare fixed", [&] {node->undeclare_parameter("fixed");});
  say("has", node->has_parameter("loose"), node->has_parameter("fixed"));

  // Asked for
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.add_node(other);
  const auto ask = [&](auto client, auto request) {
      client->wait_for_service();
      auto future = client->async_send_request(request);
      executor.spin_until_future_complete(future);
      return future.get();
    };
  using rcl_interfaces::srv::ListParameters;
  auto lister = other->create_client<ListParameters>("configured/list_parameters");
  const std::vector<std::pair<Words, std::uint64_t>> kQuestions = {
    {{}, 0}, {{}, 1}, {{"arm"}, 0}, {{"arm"}, 1}, {{"arm.length"}, 0}};
  for (const auto & [prefixes, depth] : kQuestions) {
    auto request = std::make_shared<ListParameters::Request>();
    request->prefixes = prefixes;
    request->depth = depth;
    const auto listed = ask(lister, request)->result;
    Words line;
    for (const auto & name : listed.names) {
      if (own(name)) {line.push_back(name);}
    }
    std::sort(line.begin(), line.end());
    line.insert(line.end(), listed.prefixes.begin(), listed.prefixes.end());
    say("list", line);
  }
  using rcl_interfaces::srv::GetParameters;
  auto get = std::make_shared<GetParameters::Request>();
  get->names = {"even", "nothing"};
  say(
    "get", ask(
      other->create_client<GetParameters>("configured/get_parameters"), get)->values.size());
  using rcl_interfaces::srv::DescribeParameters;
  auto describe = std::make_shared<DescribeParameters::Request>();
  describe->names = {"even"};
  const auto described = ask(
    other->create_client<DescribeParameters>("configured/describe_parameters"), describe);
  for (const auto & each : described->descriptors) {
    const auto & steps = each.integer_range.at(0);
    say(each.name, int(each.type), each.description, each.read_only, steps.to_value, steps.step);
  }
  using rcl_interfaces::srv::SetParameters;
  auto set = std::make_shared<SetParameters::Request>();
  for (const auto & each : std::vector<Parameter>{
      {"even", 2}, {"even", 3}, {"fixed", 3}, {"nothing", 3}})
  {
    set->parameters.push_back(each.to_parameter_msg());
  }
  std::cout << "set";
  const auto done = ask(other->create_client<SetParameters>("configured/set_parameters"), set);
  for (const auto & each : done->results) {std::cout << (each.successful ? " True" : " False");}
  std::cout << std::endl;

  // Told
  const auto last = [](const ParameterEvent & event) {
      return std::any_of(
        event.changed_parameters.begin(), event.changed_parameters.end(), [](const auto & each) {
          return each.name == "even" && each.value.integer_value == 2;
        });
    };
  while (std::none_of(events.begin(), events.end(), last)) {executor.spin_once(100ms);}
  for (const auto & event : events) {
    if (event.node != "/configured") {continue;}
    const auto tell = [](const char * what, const Words & which) {
        if (!which.empty()) {say("event", what, which);}
      };
    tell("new", names(event.new_parameters));
    tell("changed", names(event.changed_parameters));
    tell("deleted", names(event.deleted_parameters));
  }
}
