// Offers one thing of each kind to scripts.

#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "example_interfaces/action/fibonacci.hpp"
#include "example_interfaces/srv/add_two_ints.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "std_msgs/msg/string.hpp"
#include "tf2_msgs/msg/tf_message.hpp"

using namespace std::chrono_literals;
using Fibonacci = example_interfaces::action::Fibonacci;
using Goal = rclcpp_action::ServerGoalHandle<Fibonacci>;
using AddTwoInts = example_interfaces::srv::AddTwoInts;

class Robot : public rclcpp::Node {
 public:
  Robot() : Node("robot") {
    declare_parameter("speed", 1.5);
    declare_parameter("count", 3);
    declare_parameter("label", "first");
    rcl_interfaces::msg::ParameterDescriptor fixed, ranged, stepped, dynamic;
    fixed.read_only = true;
    ranged.description = "in m/s";
    ranged.floating_point_range.resize(1);
    ranged.floating_point_range[0].from_value = -1.0;
    ranged.floating_point_range[0].to_value = 1.5;
    ranged.floating_point_range[0].step = 0.25;
    stepped.integer_range.resize(1);
    stepped.integer_range[0].from_value = 1;
    stepped.integer_range[0].to_value = 10;
    stepped.integer_range[0].step = 3;
    dynamic.dynamic_typing = true;
    declare_parameter("robot.name", "r2", fixed);
    declare_parameter("robot.limits.linear", 0.5, ranged);
    declare_parameter("robot.limits.gears", 4, stepped);
    declare_parameter("anything", std::vector<double>{1.0, 2.5}, dynamic);
    latched_ = create_publisher<std_msgs::msg::String>("latched", rclcpp::QoS(1).transient_local());
    said("once");
    chatter_ = create_publisher<std_msgs::msg::String>("chatter", 10);
    tf_ = create_publisher<tf2_msgs::msg::TFMessage>("/tf", 100);
    fixed_ = create_publisher<tf2_msgs::msg::TFMessage>("/tf_static", rclcpp::QoS(1).transient_local());
    fixed_->publish(transforms("world", "map", 10));
    echo_ = create_subscription<std_msgs::msg::String>("echo", 10, [this](const std_msgs::msg::String& message) {
      RCLCPP_INFO(get_logger(), "heard '%s'", message.data.c_str());
    });
    add_ = create_service<AddTwoInts>("add_two_ints", [](const std::shared_ptr<AddTwoInts::Request> request,
                                                         std::shared_ptr<AddTwoInts::Response> response) {
      response->sum = request->a + request->b;
    });
    timer_ = create_wall_timer(50ms, [this]() {
      auto message = std_msgs::msg::String();
      message.data = "Hello " + std::to_string(++number_);
      chatter_->publish(message);
      tf_->publish(transforms("map", "turtle1", 0.1 * number_));
    });
    server_ = rclcpp_action::create_server<Fibonacci>(
        this, "fibonacci",
        [](const rclcpp_action::GoalUUID&, std::shared_ptr<const Fibonacci::Goal> goal) {
          return goal->order < 0 ? rclcpp_action::GoalResponse::REJECT
                                 : rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
        },
        [](const std::shared_ptr<Goal>) { return rclcpp_action::CancelResponse::ACCEPT; },
        [](const std::shared_ptr<Goal> goal) { std::thread(run, goal).detach(); });
  }

 private:
  static void run(const std::shared_ptr<Goal> goal) {
    auto feedback = std::make_shared<Fibonacci::Feedback>();
    auto result = std::make_shared<Fibonacci::Result>();
    auto& sequence = feedback->sequence;
    sequence = {0, 1};
    for (int i = 1; i < goal->get_goal()->order; ++i) {
      if (goal->is_canceling()) {
        result->sequence = sequence;
        goal->canceled(result);
        return;
      }
      sequence.push_back(sequence[i] + sequence[i - 1]);
      goal->publish_feedback(feedback);
      std::this_thread::sleep_for(20ms);
    }
    result->sequence = sequence;
    if (goal->get_goal()->order == 13) goal->abort(result);
    else goal->succeed(result);
  }

  tf2_msgs::msg::TFMessage transforms(const std::string& parent, const std::string& child, double x) {
    geometry_msgs::msg::TransformStamped one;
    one.header.stamp = now();
    one.header.frame_id = parent;
    one.child_frame_id = child;
    one.transform.translation.x = x;
    one.transform.rotation.w = 1;
    tf2_msgs::msg::TFMessage message;
    message.transforms.push_back(one);
    return message;
  }

  void said(const std::string& text) {
    auto message = std_msgs::msg::String();
    message.data = text;
    latched_->publish(message);
  }

  int number_ = 0;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr latched_, chatter_;
  rclcpp::Publisher<tf2_msgs::msg::TFMessage>::SharedPtr tf_, fixed_;
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr echo_;
  rclcpp::Service<AddTwoInts>::SharedPtr add_;
  rclcpp::TimerBase::SharedPtr timer_;
  rclcpp_action::Server<Fibonacci>::SharedPtr server_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
  rclcpp::shutdown();
}
