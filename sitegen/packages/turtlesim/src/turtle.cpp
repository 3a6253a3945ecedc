#include "turtle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
// For the action: angular velocity (rad/s) and tolerance (rad).
constexpr double TURNING = 1;
constexpr double NEAR = 0.02;
// A turtle stops this long after its last command (s).
constexpr double PATIENCE = 1;

double wrapped(double angle)
{
  return std::remainder(angle, 2 * M_PI);
}
}  // namespace

Turtle::Turtle(
  rclcpp::Node & node, const std::string & name, std::uint32_t number, Point place,
  double heading, std::function<void()> changed)
: node_(node), name_(name), number_(number), changed_(std::move(changed)), place_(place),
  heading_(heading), commanded_(node.now())
{
  const rclcpp::QoS qos(7);
  poses_ = node.create_publisher<interfaces::msg::Pose>(name + "/pose", qos);
  colors_ = node.create_publisher<interfaces::msg::Color>(name + "/color_sensor", qos);
  commands_ = node.create_subscription<geometry_msgs::msg::Twist>(
    name + "/cmd_vel", qos, [this](geometry_msgs::msg::Twist::ConstSharedPtr twist) {
      const bool holonomic = node_.get_parameter("holonomic").as_bool();
      obey(twist->linear.x, holonomic ? twist->linear.y : 0, twist->angular.z);
    });
  serve(name);
}

void Turtle::serve(const std::string & name)
{
  using interfaces::srv::SetPen;
  using interfaces::srv::TeleportAbsolute;
  using interfaces::srv::TeleportRelative;
  set_pen_ = node_.create_service<SetPen>(
    name + "/set_pen", [this](SetPen::Request::SharedPtr asked, SetPen::Response::SharedPtr) {
      pen_down_ = !asked->off;
      if (pen_down_) {
        pen_ = {asked->r, asked->g, asked->b};
        pen_width_ = std::max<int>(asked->width, 1);
      }
      changed_();
    });
  teleport_relative_ = node_.create_service<TeleportRelative>(
    name + "/teleport_relative",
    [this](TeleportRelative::Request::SharedPtr asked, TeleportRelative::Response::SharedPtr) {
      teleports_.push_back([this, asked](Canvas & canvas) {
          heading_ += asked->angular;
          go({place_.x + std::cos(heading_) * asked->linear,
              place_.y + std::sin(heading_) * asked->linear}, canvas);
        });
    });
  teleport_absolute_ = node_.create_service<TeleportAbsolute>(
    name + "/teleport_absolute",
    [this](TeleportAbsolute::Request::SharedPtr asked, TeleportAbsolute::Response::SharedPtr) {
      teleports_.push_back([this, asked](Canvas & canvas) {
          heading_ = asked->theta;
          go({asked->x, asked->y}, canvas);
        });
    });
  rotate_absolute_ = rclcpp_action::create_server<RotateAbsolute>(
    &node_, name + "/rotate_absolute",
    [](const auto &, const auto &) {return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;},
    [](const auto &) {return rclcpp_action::CancelResponse::ACCEPT;},
    [this](std::shared_ptr<Goal> goal) {rotate_to(std::move(goal));});
}

void Turtle::obey(double linear, double lateral, double angular)
{
  commanded_ = node_.now();
  linear_ = linear;
  lateral_ = lateral;
  angular_ = angular;
}

void Turtle::rotate_to(std::shared_ptr<Goal> goal)
{
  if (goal_) {
    RCLCPP_WARN(
      node_.get_logger(),
      "Rotation goal received before a previous goal finished. Aborting previous goal");
    auto result = std::make_shared<RotateAbsolute::Result>();
    result->delta = goal_from_ - heading_;
    goal_->abort(result);
  }
  goal_ = std::move(goal);
  goal_from_ = heading_;
}

void Turtle::rotate()
{
  auto result = std::make_shared<RotateAbsolute::Result>();
  result->delta = goal_from_ - heading_;
  const double remaining = wrapped(goal_->get_goal()->theta - heading_);
  const bool there = std::abs(remaining) < NEAR;
  if (there || goal_->is_canceling()) {
    obey(0, 0, 0);
    if (goal_->is_canceling()) {
      RCLCPP_INFO(node_.get_logger(), "Rotation goal canceled");
      goal_->canceled(result);
    } else {
      RCLCPP_INFO(node_.get_logger(), "Rotation goal completed successfully");
      goal_->succeed(result);
    }
    goal_.reset();
    return;
  }
  obey(0, 0, remaining < 0 ? -TURNING : TURNING);
  auto feedback = std::make_shared<RotateAbsolute::Feedback>();
  feedback->remaining = remaining;
  goal_->publish_feedback(feedback);
}

void Turtle::update(double seconds, Canvas & canvas)
{
  for (const auto & teleport : std::exchange(teleports_, {})) {teleport(canvas);}
  if ((node_.now() - commanded_).seconds() > PATIENCE) {linear_ = lateral_ = angular_ = 0;}
  if (goal_) {rotate();}
  heading_ = wrapped(heading_ + angular_ * seconds);
  const double ahead = linear_ * seconds;
  const double aside = lateral_ * seconds;
  go({place_.x + std::cos(heading_) * ahead - std::sin(heading_) * aside,
      place_.y + std::sin(heading_) * ahead + std::cos(heading_) * aside}, canvas);
  publish(canvas);
}

void Turtle::go(Point place, Canvas & canvas)
{
  const Point inside{
    std::clamp(place.x, 0.0, Canvas::EXTENT), std::clamp(place.y, 0.0, Canvas::EXTENT)};
  if (inside.x != place.x || inside.y != place.y) {
    RCLCPP_WARN(
      node_.get_logger(), "Oh no! I hit the wall! (Clamping from [x=%f, y=%f])", place.x, place.y);
  }
  const bool moved = inside.x != place_.x || inside.y != place_.y;
  if (moved && pen_down_) {canvas.line(place_, inside, pen_width_, pen_);}
  place_ = inside;
}

void Turtle::publish(const Canvas & canvas)
{
  interfaces::msg::Pose pose;
  pose.x = place_.x;
  pose.y = place_.y;
  pose.theta = heading_;
  pose.linear_velocity = lateral_ == 0 ? linear_ : std::hypot(linear_, lateral_);
  pose.angular_velocity = angular_;
  poses_->publish(pose);
  const Rgb below = canvas.at(place_);
  interfaces::msg::Color color;
  color.r = below.r;
  color.g = below.g;
  color.b = below.b;
  colors_->publish(color);
}

turtlesim_window::msg::Turtle Turtle::look() const
{
  turtlesim_window::msg::Turtle look;
  look.name = name_;
  look.number = number_;
  look.pose = poses_->get_topic_name();
  look.cmd_vel = commands_->get_topic_name();
  look.r = pen_.r;
  look.g = pen_.g;
  look.b = pen_.b;
  look.width = pen_down_ ? pen_width_ : 0;
  return look;
}
