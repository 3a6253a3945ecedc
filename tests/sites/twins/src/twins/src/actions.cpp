#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "test_msgs/action/fibonacci.hpp"
#include "twins.hpp"

using namespace std::chrono_literals;
using test_msgs::action::Fibonacci;
using ServerGoal = rclcpp_action::ServerGoalHandle<Fibonacci>;
using ClientGoal = rclcpp_action::ClientGoalHandle<Fibonacci>;

namespace
{

using Numbers = std::vector<std::int32_t>;
std::vector<Numbers> heard;

std::vector<std::string> words(const Numbers & numbers)
{
  std::vector<std::string> found;
  for (const auto number : numbers) {found.push_back(std::to_string(number));}
  return found;
}

void execute(const std::shared_ptr<ServerGoal> goal)
{
  const auto order = goal->get_goal()->order;
  auto feedback = std::make_shared<Fibonacci::Feedback>();
  auto result = std::make_shared<Fibonacci::Result>();
  auto & sequence = feedback->sequence;
  sequence = {0, 1};
  for (int i = 1; i < order; ++i) {
    if (goal->is_canceling()) {
      result->sequence = sequence;
      goal->canceled(result);
      return;
    }
    sequence.push_back(sequence[i] + sequence[i - 1]);
    goal->publish_feedback(feedback);
    if (order > 10) {std::this_thread::sleep_for(100ms);}
    // Who has the result hears no more feedback, so each waits for its own to be heard.
    while (order < 10 && heard.size() < static_cast<std::size_t>(i)) {
      std::this_thread::sleep_for(10ms);
    }
  }
  result->sequence = sequence;
  if (order == 3) {
    goal->abort(result);
  } else {
    goal->succeed(result);
  }
}

}  // namespace

void play_actions()
{
  auto server = std::make_shared<rclcpp::Node>("server");
  auto asker = std::make_shared<rclcpp::Node>("asker");
  std::vector<std::thread> threads;
  auto action = rclcpp_action::create_server<Fibonacci>(
    server, "fibonacci",
    [](const rclcpp_action::GoalUUID &, std::shared_ptr<const Fibonacci::Goal> goal) {
      return goal->order < 0 ? rclcpp_action::GoalResponse::REJECT :
      rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
    },
    [](const std::shared_ptr<ServerGoal> goal) {
      return goal->get_goal()->order == 21 ? rclcpp_action::CancelResponse::REJECT :
      rclcpp_action::CancelResponse::ACCEPT;
    },
    [&](const std::shared_ptr<ServerGoal> goal) {threads.emplace_back(execute, goal);});
  auto client = rclcpp_action::create_client<Fibonacci>(asker, "fibonacci");
  auto nobody = rclcpp_action::create_client<Fibonacci>(asker, "nobody");
  rclcpp::executors::MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 4);
  executor.add_node(server);
  executor.add_node(asker);

  const auto wait = [&](auto future) {
      executor.spin_until_future_complete(future, 30s);
      return future.get();
    };
  const auto send = [&](int order) {
      Fibonacci::Goal goal;
      goal.order = order;
      rclcpp_action::Client<Fibonacci>::SendGoalOptions options;
      options.feedback_callback =
        [](ClientGoal::SharedPtr, const std::shared_ptr<const Fibonacci::Feedback> feedback) {
          heard.push_back(feedback->sequence);
        };
      return wait(client->async_send_goal(goal, options));
    };
  say("nobody", nobody->wait_for_action_server(100ms));
  say("server", client->wait_for_action_server(10s));
  for (const int order : {6, 3, -1, 0}) {
    heard.clear();
    const auto goal = send(order);
    say(order, "accepted", goal != nullptr);
    if (goal) {
      const auto answer = wait(client->async_get_result(goal));
      say("status", int(answer.code), words(answer.result->sequence));
    }
    for (const auto & each : heard) {say("feedback", words(each));}
  }
  const auto lengthy = send(40);
  const auto stubborn = send(21);
  const auto status = lengthy->get_status();
  say(
    "running", status == rclcpp_action::GoalStatus::STATUS_ACCEPTED ||
    status == rclcpp_action::GoalStatus::STATUS_EXECUTING);
  for (const auto & goal : {lengthy, stubborn}) {
    const auto response = wait(client->async_cancel_goal(goal));
    say("cancelling", response->goals_canceling.size());
  }
  auto answer = wait(client->async_get_result(lengthy));
  say("status", int(answer.code), answer.result->sequence.size() < 40);
  answer = wait(client->async_get_result(stubborn));
  say("status", int(answer.code), answer.result->sequence.size());
  try {
    say("too late", int(wait(client->async_cancel_goal(stubborn))->return_code));
  } catch (const rclcpp_action::exceptions::UnknownGoalHandleError &) {
    say("too late 3");  // rclcpp's client knows it without asking
  }
  for (auto & thread : threads) {thread.join();}
}
