// Does everything with native nodes that nodes do with each other, and prints what comes of it.

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/set_bool.hpp"
#include "test_msgs/action/fibonacci.hpp"

using namespace std::chrono_literals;
using std_msgs::msg::String;
using std_srvs::srv::SetBool;
using test_msgs::action::Fibonacci;
using ServerGoal = rclcpp_action::ServerGoalHandle<Fibonacci>;
using ClientGoal = rclcpp_action::ClientGoalHandle<Fibonacci>;

class Station : public rclcpp::Node
{
public:
  Station()
  : Node("station")
  {
    declare_parameter("speed", 1.5);
    const auto latched = rclcpp::QoS(5).transient_local();
    chatter_ = create_publisher<String>("/page/chatter", 100);
    map_ = create_publisher<String>("/page/map", latched);
    map_->publish(text("map of the page"));
    heard_ = create_subscription<String>(
      "/robot/chatter", 100,
      [this](const String & m) {RCLCPP_INFO(get_logger(), "heard %s", m.data.c_str());});
    charted_ = create_subscription<String>(
      "/robot/map", latched,
      [this](const String & m) {RCLCPP_INFO(get_logger(), "charted %s", m.data.c_str());});
    late_ = create_subscription<String>(
      "/robot/map", 5,
      [this](const String & m) {RCLCPP_INFO(get_logger(), "late %s", m.data.c_str());});
    server_ = create_service<SetBool>(
      "/page/set",
      [](const SetBool::Request::SharedPtr request, SetBool::Response::SharedPtr response) {
        response->success = request->data;
        response->message = "from the page";
      });
    client_ = create_client<SetBool>("/robot/set");
    action_ = rclcpp_action::create_server<Fibonacci>(
      this, "/page/fibonacci",
      [](const rclcpp_action::GoalUUID &, std::shared_ptr<const Fibonacci::Goal>) {
        return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
      },
      [](const std::shared_ptr<ServerGoal>) {return rclcpp_action::CancelResponse::ACCEPT;},
      [](const std::shared_ptr<ServerGoal> goal) {std::thread(execute, goal).detach();});
    goals_ = rclcpp_action::create_client<Fibonacci>(this, "/robot/fibonacci");
    timer_ = create_wall_timer(100ms, [this]() {tick();});
  }

private:
  static String text(const std::string & data)
  {
    String message;
    message.data = data;
    return message;
  }

  static void execute(const std::shared_ptr<ServerGoal> goal)
  {
    auto feedback = std::make_shared<Fibonacci::Feedback>();
    feedback->sequence = {0, 1};
    auto result = std::make_shared<Fibonacci::Result>();
    for (int i = 1; i < goal->get_goal()->order; ++i) {
      if (goal->is_canceling()) {
        goal->canceled(result);
        return;
      }
      // Larger numbers have no room. Who asks for them has to cancel.
      if (i < 46) {
        feedback->sequence.push_back(feedback->sequence[i] + feedback->sequence[i - 1]);
      }
      goal->publish_feedback(feedback);
      std::this_thread::sleep_for(20ms);
    }
    result->sequence = feedback->sequence;
    goal->succeed(result);
  }

  void tick()
  {
    chatter_->publish(text("page " + std::to_string(++count_)));
    if (!asked_ && client_->service_is_ready()) {
      asked_ = true;
      auto request = std::make_shared<SetBool::Request>();
      request->data = true;
      client_->async_send_request(
        request, [this](rclcpp::Client<SetBool>::SharedFuture future) {
          RCLCPP_INFO(get_logger(), "answered %s", future.get()->message.c_str());
        });
    }
    if (!sent_ && goals_->action_server_is_ready()) {
      sent_ = true;
      Fibonacci::Goal goal;
      goal.order = 5;
      rclcpp_action::Client<Fibonacci>::SendGoalOptions options;
      options.result_callback = [this](const ClientGoal::WrappedResult & result) {
          std::string numbers;
          for (const auto number : result.result->sequence) {
            numbers += " " + std::to_string(number);
          }
          RCLCPP_INFO(get_logger(), "reached%s", numbers.c_str());
        };
      goals_->async_send_goal(goal, options);
    }
    // Without a server, both are tried again when there is one.
    if (!client_->service_is_ready()) {asked_ = false;}
    if (!goals_->action_server_is_ready()) {sent_ = false;}
  }

  rclcpp::Publisher<String>::SharedPtr chatter_, map_;
  rclcpp::Subscription<String>::SharedPtr heard_, charted_, late_;
  rclcpp::Service<SetBool>::SharedPtr server_;
  rclcpp::Client<SetBool>::SharedPtr client_;
  rclcpp_action::Server<Fibonacci>::SharedPtr action_;
  rclcpp_action::Client<Fibonacci>::SharedPtr goals_;
  rclcpp::TimerBase::SharedPtr timer_;
  int count_ = 0;
  bool asked_ = false;
  bool sent_ = false;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Station>());
  rclcpp::shutdown();
  return 0;
}
