// A turtle: follows commands, publishes its pose and draws.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "canvas.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "interfaces.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "turtlesim_window/msg/turtle.hpp"

class Turtle
{
public:
  // `changed` is called when its pen changes.
  Turtle(
    rclcpp::Node & node, const std::string & name, std::uint32_t number, Point place,
    double heading, std::function<void()> changed);

  // Move and draw for the duration of one frame (s).
  void update(double seconds, Canvas & canvas);

  turtlesim_window::msg::Turtle look() const;

private:
  using RotateAbsolute = interfaces::action::RotateAbsolute;
  using Goal = rclcpp_action::ServerGoalHandle<RotateAbsolute>;

  void serve(const std::string & name);
  void rotate_to(std::shared_ptr<Goal> goal);
  void rotate();
  void go(Point place, Canvas & canvas);
  void publish(const Canvas & canvas);
  void obey(double linear, double lateral, double angular);

  rclcpp::Node & node_;
  std::string name_;
  std::uint32_t number_;
  std::function<void()> changed_;
  Point place_;
  double heading_;
  double linear_ = 0;
  double lateral_ = 0;
  double angular_ = 0;
  rclcpp::Time commanded_;
  bool pen_down_ = true;
  Rgb pen_{0xb3, 0xb8, 0xff};
  int pen_width_ = 3;
  // Teleports wait for the next frame.
  std::vector<std::function<void(Canvas &)>> teleports_;
  std::shared_ptr<Goal> goal_;
  double goal_from_ = 0;

  rclcpp::Publisher<interfaces::msg::Pose>::SharedPtr poses_;
  rclcpp::Publisher<interfaces::msg::Color>::SharedPtr colors_;
  rclcpp::Subscription<geometry_msgs::msg::Twist>::SharedPtr commands_;
  rclcpp::Service<interfaces::srv::SetPen>::SharedPtr set_pen_;
  rclcpp::Service<interfaces::srv::TeleportRelative>::SharedPtr teleport_relative_;
  rclcpp::Service<interfaces::srv::TeleportAbsolute>::SharedPtr teleport_absolute_;
  rclcpp_action::Server<RotateAbsolute>::SharedPtr rotate_absolute_;
};
