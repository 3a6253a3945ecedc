#include <functional>
#include <memory>
#include <thread>

#include "components/shape.hpp"
#include "example_interfaces/action/fibonacci.hpp"
#include "pluginlib/class_loader.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "rclcpp_components/register_node_macro.hpp"

namespace components
{

class FibonacciServer : public rclcpp::Node
{
public:
  using Fibonacci = example_interfaces::action::Fibonacci;
  using GoalHandle = rclcpp_action::ServerGoalHandle<Fibonacci>;

  explicit FibonacciServer(const rclcpp::NodeOptions & options = rclcpp::NodeOptions())
  : Node("fibonacci_server", options)
  {
    using std::placeholders::_1;
    using std::placeholders::_2;
    server_ = rclcpp_action::create_server<Fibonacci>(
      this, "fibonacci", std::bind(&FibonacciServer::handle_goal, this, _1, _2),
      std::bind(&FibonacciServer::handle_cancel, this, _1),
      std::bind(&FibonacciServer::handle_accepted, this, _1));
    pluginlib::ClassLoader<Shape> shapes("components", "components::Shape");
    for (const auto & name : shapes.getDeclaredClasses()) {
      RCLCPP_INFO(rclcpp::get_logger("shapes"), "there is %s", name.c_str());
    }
  }

private:
  rclcpp_action::GoalResponse handle_goal(
    const rclcpp_action::GoalUUID &, std::shared_ptr<const Fibonacci::Goal> goal)
  {
    RCLCPP_INFO(get_logger(), "asked for %d", goal->order);
    return goal->order > 40 ? rclcpp_action::GoalResponse::REJECT :
           rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
  }

  rclcpp_action::CancelResponse handle_cancel(const std::shared_ptr<GoalHandle>)
  {
    RCLCPP_INFO(get_logger(), "asked to cancel");
    return rclcpp_action::CancelResponse::ACCEPT;
  }

  void handle_accepted(const std::shared_ptr<GoalHandle> handle)
  {
    std::thread{std::bind(&FibonacciServer::execute, this, std::placeholders::_1), handle}.detach();
  }

  void execute(const std::shared_ptr<GoalHandle> handle)
  {
    const auto goal = handle->get_goal();
    // The one that is canceled goes on for long enough, however slow the machine is.
    rclcpp::Rate rate(goal->order == 40 ? 5.0 : 100.0);
    auto feedback = std::make_shared<Fibonacci::Feedback>();
    auto & sequence = feedback->sequence;
    sequence = {0, 1};
    auto result = std::make_shared<Fibonacci::Result>();
    for (int i = 1; i < goal->order && rclcpp::ok(); ++i) {
      if (handle->is_canceling()) {
        result->sequence = sequence;
        handle->canceled(result);
        RCLCPP_INFO(get_logger(), "canceled");
        return;
      }
      sequence.push_back(sequence[i] + sequence[i - 1]);
      handle->publish_feedback(feedback);
      rate.sleep();
    }
    result->sequence = sequence;
    if (goal->order < 0) {
      handle->abort(result);
    } else {
      handle->succeed(result);
    }
  }

  rclcpp_action::Server<Fibonacci>::SharedPtr server_;
};

}  // namespace components

RCLCPP_COMPONENTS_REGISTER_NODE(components::FibonacciServer)
