// Makes one turtle (output/cmd_vel) mimic another (input/pose).
#include <memory>

#include "geometry_msgs/msg/twist.hpp"
#include "interfaces.hpp"
#include "rclcpp/rclcpp.hpp"

class Mimic : public rclcpp::Node
{
public:
  Mimic()
  : Node("turtle_mimic")
  {
    commands_ = create_publisher<geometry_msgs::msg::Twist>("output/cmd_vel", 1);
    poses_ = create_subscription<interfaces::msg::Pose>(
      "input/pose", 1, [this](interfaces::msg::Pose::ConstSharedPtr pose) {
        geometry_msgs::msg::Twist twist;
        twist.linear.x = pose->linear_velocity;
        twist.angular.z = pose->angular_velocity;
        commands_->publish(twist);
      });
  }

private:
  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr commands_;
  rclcpp::Subscription<interfaces::msg::Pose>::SharedPtr poses_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Mimic>());
  rclcpp::shutdown();
  return 0;
}
