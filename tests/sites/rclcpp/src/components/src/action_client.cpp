#include <functional>
#include <memory>
#include <sstream>

#include "example_interfaces/action/fibonacci.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "rclcpp_components/register_node_macro.hpp"

namespace components
{

// Sends one goal after the other: one that ends, one that is refused, one that fails, one that is canceled.
class FibonacciClient : public rclcpp::Node
{
public:
  using Fibonacci = example_interfaces::action::Fibonacci;
  using GoalHandle = rclcpp_action::ClientGoalHandle<Fibonacci>;

  explicit FibonacciClient(const rclcpp::NodeOptions & options)
  : Node("fibonacci_client", options),
    client_(rclcpp_action::create_client<Fibonacci>(this, "fibonacci"))
  {
    timer_ = create_wall_timer(std::chrono::milliseconds(1), [this] {begin();});
  }

private:
  void begin()
  {
    timer_->cancel();
    if (!client_->wait_for_action_server(std::chrono::seconds(30))) {
      RCLCPP_ERROR(get_logger(), "no server");
      rclcpp::shutdown();
      return;
    }
    send(6);
  }

  void send(int order)
  {
    feedback_ = 0;
    Fibonacci::Goal goal;
    goal.order = order;
    auto options = rclcpp_action::Client<Fibonacci>::SendGoalOptions();
    options.goal_response_callback = [this](const GoalHandle::SharedPtr & handle) {
        RCLCPP_INFO(get_logger(), handle ? "accepted" : "refused");
        if (!handle) {send(-1);}
      };
    options.feedback_callback =
      std::bind(&FibonacciClient::feedback, this, std::placeholders::_1, std::placeholders::_2);
    options.result_callback = [this, order](const GoalHandle::WrappedResult & result) {
        std::stringstream text;
        for (const auto number : result.result->sequence) {text << number << " ";}
        if (order == 40) {text.str("");}  // as far as it came
        RCLCPP_INFO(
          get_logger(), "result %d %s%s", static_cast<int>(result.code), text.str().c_str(),
          feedback_ > 0 ? "after feedback" : "");
        next(order);
      };
    client_->async_send_goal(goal, options);
  }

  void feedback(
    GoalHandle::SharedPtr handle, const std::shared_ptr<const Fibonacci::Feedback> feedback)
  {
    ++feedback_;
    if (feedback_ == 3 && feedback->sequence.size() > 2 && canceling_) {
      client_->async_cancel_goal(handle, [this](auto response) {
          RCLCPP_INFO(
            get_logger(), "canceling %zu, %d", response->goals_canceling.size(),
            response->return_code);
        });
    }
  }

  void next(int order)
  {
    if (order == 6) {
      send(41);
    } else if (order == -1) {
      canceling_ = true;
      send(40);
    } else {
      client_->async_cancel_all_goals([this](auto response) {
          RCLCPP_INFO(get_logger(), "none left: %zu", response->goals_canceling.size());
          rclcpp::shutdown();
        });
    }
  }

  bool canceling_ = false;
  int feedback_ = 0;
  rclcpp_action::Client<Fibonacci>::SharedPtr client_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace components

RCLCPP_COMPONENTS_REGISTER_NODE(components::FibonacciClient)
