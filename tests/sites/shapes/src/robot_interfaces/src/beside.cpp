#include "rclcpp/rclcpp.hpp"
#include "robot_interfaces/action/drive.hpp"
#include "robot_interfaces/msg/chassis.hpp"
#include "robot_interfaces/srv/weigh.hpp"

using robot_interfaces::msg::Wheel;

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("beside");

  robot_interfaces::msg::Chassis chassis;
  chassis.corners.resize(1);
  const auto & wheel = chassis.wheels[3];
  RCLCPP_INFO(
    node->get_logger(), "%s %zu wheels, %g m, %d of %s", wheel.label.c_str(),
    chassis.wheels.size(), wheel.radius, wheel.ticks[1], Wheel::MAKER.c_str());
  RCLCPP_INFO(
    node->get_logger(), "corner %d %d", static_cast<int>(chassis.corners[0].number),
    static_cast<int>(robot_interfaces::msg::Corner::LEFT));
  robot_interfaces::srv::Weigh::Response response;
  robot_interfaces::action::Drive::Goal goal;
  goal.metres = Wheel::TURN;
  RCLCPP_INFO(node->get_logger(), "%g kg %g m", response.kilograms, goal.metres);
  rclcpp::shutdown();
  return 0;
}
