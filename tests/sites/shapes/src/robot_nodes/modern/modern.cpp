#include <memory>
#include <span>

#include "rclcpp/rclcpp.hpp"
#include "robot_arm/arm.hpp"
#include "robot_interfaces/msg/chassis.hpp"
#include "robot_nodes/common.hpp"
#include "std_msgs/msg/string.hpp"

/// Sends itself a message of another package and stops when it has come.
class Modern : public rclcpp::Node
{
public:
  Modern()
  : Node("modern")
  {
    using robot_interfaces::msg::Chassis;
    publisher_ = create_publisher<Chassis>("chassis", 10);
    subscription_ = create_subscription<Chassis>(
      "chassis", 10, [this](const Chassis & chassis) {
        RCLCPP_INFO(
          get_logger(), "%s after %u: %s, %zu wheels, %zu spare", GREETING, checksum("abc", LIMIT),
          robot_arm::hold(chassis.wheels[0]).c_str(), std::span(chassis.wheels).size(),
          chassis.spare.size());
        rclcpp::shutdown();
      });
    timer_ = create_wall_timer(
      std::chrono::milliseconds(20), [this]() {
        Chassis chassis;
        chassis.spare.resize(2);
        chassis.wheels[0].label = "left";
        publisher_->publish(chassis);
      });
  }

private:
  rclcpp::Publisher<robot_interfaces::msg::Chassis>::SharedPtr publisher_;
  rclcpp::Subscription<robot_interfaces::msg::Chassis>::SharedPtr subscription_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Modern>());
}
