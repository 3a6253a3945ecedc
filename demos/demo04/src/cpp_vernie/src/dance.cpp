// Publishes the steps of a dance on /cmd_vel, and waits while something is in the way.
#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>

#include "geometry_msgs/msg/twist.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/float32.hpp"

using namespace std::chrono_literals;
using std::placeholders::_1;

struct Step
{
  const char * name;
  double speed;
  double turn;
  int ticks;
};

class Dancer : public rclcpp::Node
{
public:
  Dancer()
  : Node("dancer")
  {
    publisher_ = create_publisher<geometry_msgs::msg::Twist>("cmd_vel", 10);
    subscription_ = create_subscription<std_msgs::msg::Float32>(
      "vernie/distance", 10, std::bind(&Dancer::on_distance, this, _1));
    timer_ = create_wall_timer(100ms, std::bind(&Dancer::on_timer, this));
  }

private:
  // #region steps
  void on_timer()
  {
    static const std::array<Step, 6> steps{{
      {"forward", 0.8, 0.0, 12},
      {"a curve to the left", 0.6, 0.25, 22},
      {"a pirouette", 0.0, -0.9, 20},
      {"back", -0.5, 0.0, 10},
      {"a curve to the right", 0.6, -0.25, 22},
      {"a rest", 0.0, 0.0, 6},
    }};
    geometry_msgs::msg::Twist twist;
    if (!blocked_) {
      const Step & step = steps[step_];
      if (tick_ == 0) {
        RCLCPP_INFO(get_logger(), "Now %s", step.name);
      }
      twist.linear.x = step.speed;
      twist.angular.z = step.turn;
      if (++tick_ == step.ticks) {
        tick_ = 0;
        step_ = (step_ + 1) % steps.size();
      }
    }
    publisher_->publish(twist);
  }
  // #endregion

  void on_distance(const std_msgs::msg::Float32 & distance)
  {
    const bool blocked = distance.data < 0.1f;
    if (blocked && !blocked_) {
      RCLCPP_WARN(get_logger(), "Something is %.2f m before me: I wait", distance.data);
    } else if (!blocked && blocked_) {
      RCLCPP_INFO(get_logger(), "The way is free: I go on");
    }
    blocked_ = blocked;
  }

  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr publisher_;
  rclcpp::Subscription<std_msgs::msg::Float32>::SharedPtr subscription_;
  rclcpp::TimerBase::SharedPtr timer_;
  std::size_t step_ = 0;
  int tick_ = 0;
  bool blocked_ = false;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Dancer>());
  rclcpp::shutdown();
  return 0;
}
