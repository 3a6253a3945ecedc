// Asks a script for what it offers: /page/add, /page/fibonacci. Prints the answers.

#include <chrono>
#include <memory>

#include "example_interfaces/action/fibonacci.hpp"
#include "example_interfaces/srv/add_two_ints.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

using namespace std::chrono_literals;
using Fibonacci = example_interfaces::action::Fibonacci;
using AddTwoInts = example_interfaces::srv::AddTwoInts;

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("asker");
  auto adder = node->create_client<AddTwoInts>("/page/add");
  adder->wait_for_service();
  auto request = std::make_shared<AddTwoInts::Request>();
  request->a = 40;
  request->b = 2;
  auto sum = adder->async_send_request(request);
  rclcpp::spin_until_future_complete(node, sum);
  RCLCPP_INFO(node->get_logger(), "sum %ld", static_cast<long>(sum.get()->sum));

  auto client = rclcpp_action::create_client<Fibonacci>(node, "/page/fibonacci");
  client->wait_for_action_server();
  for (int order : {5, 1000}) {
    int heard = 0;
    rclcpp_action::Client<Fibonacci>::SendGoalOptions options;
    options.feedback_callback = [&](auto, auto) { ++heard; };
    Fibonacci::Goal goal;
    goal.order = order;
    auto sent = client->async_send_goal(goal, options);
    rclcpp::spin_until_future_complete(node, sent);
    auto handle = sent.get();
    if (!handle) {
      RCLCPP_INFO(node->get_logger(), "rejected");
      continue;
    }
    auto result = client->async_get_result(handle);
    if (order == 1000) {
      auto canceled = client->async_cancel_goal(handle);
      rclcpp::spin_until_future_complete(node, canceled);
    }
    rclcpp::spin_until_future_complete(node, result);
    const auto wrapped = result.get();
    RCLCPP_INFO(node->get_logger(), "order %d: code %d, %zu numbers, %s", order, static_cast<int>(wrapped.code),
                wrapped.result->sequence.size(), heard > 0 ? "feedback" : "no feedback");
  }
  rclcpp::shutdown();
}
