// Makes the first turtle draw squares.
#include <chrono>
#include <cmath>
#include <memory>

#include "geometry_msgs/msg/twist.hpp"
#include "interfaces.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_srvs/srv/empty.hpp"

class DrawSquare : public rclcpp::Node
{
public:
  DrawSquare()
  : Node("draw_square")
  {
    commands_ = create_publisher<geometry_msgs::msg::Twist>("turtle1/cmd_vel", 1);
    poses_ = create_subscription<Pose>(
      "turtle1/pose", 1, [this](Pose::ConstSharedPtr pose) {pose_ = pose;});
    reset_ = create_client<std_srvs::srv::Empty>("reset");
    reset_->async_send_request(
      std::make_shared<std_srvs::srv::Empty::Request>(),
      [this](rclcpp::Client<std_srvs::srv::Empty>::SharedFuture) {pose_.reset(); is_reset_ = true;});
    timer_ = create_wall_timer(std::chrono::milliseconds(16), [this]() {step();});
  }

private:
  using Pose = interfaces::msg::Pose;
  enum class Doing {GOING, TURNING};

  static constexpr double SIDE = 2;  // m

  void step()
  {
    if (!is_reset_ || !pose_) {return;}
    if (!begun_) {go_on(Doing::GOING);}
    begun_ = true;
    if (!reached()) {
      doing_ == Doing::GOING ? command(1, 0) : command(0, 0.4);
    } else if (std::abs(pose_->linear_velocity) + std::abs(pose_->angular_velocity) > 1e-4) {
      command(0, 0);
    } else {
      RCLCPP_INFO(get_logger(), "Reached goal");
      go_on(doing_ == Doing::GOING ? Doing::TURNING : Doing::GOING);
    }
  }

  void go_on(Doing doing)
  {
    doing_ = doing;
    goal_ = *pose_;
    if (doing == Doing::GOING) {
      goal_.x += std::cos(pose_->theta) * SIDE;
      goal_.y += std::sin(pose_->theta) * SIDE;
    } else {
      goal_.theta = std::remainder(pose_->theta + M_PI / 2, 2 * M_PI);
    }
    RCLCPP_INFO(get_logger(), "New goal [%f %f, %f]", goal_.x, goal_.y, goal_.theta);
  }

  bool reached() const
  {
    return std::abs(pose_->x - goal_.x) < 0.1 && std::abs(pose_->y - goal_.y) < 0.1 &&
           std::abs(std::remainder(pose_->theta - goal_.theta, 2 * M_PI)) < 0.01;
  }

  void command(double linear, double angular)
  {
    geometry_msgs::msg::Twist twist;
    twist.linear.x = linear;
    twist.angular.z = angular;
    commands_->publish(twist);
  }

  Pose::ConstSharedPtr pose_;
  Pose goal_;
  Doing doing_ = Doing::GOING;
  bool is_reset_ = false;
  bool begun_ = false;
  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr commands_;
  rclcpp::Subscription<Pose>::SharedPtr poses_;
  rclcpp::Client<std_srvs::srv::Empty>::SharedPtr reset_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<DrawSquare>());
  rclcpp::shutdown();
  return 0;
}
