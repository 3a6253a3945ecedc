#include <memory>

#include <rclcpp/rclcpp.hpp>
#include <robot_extras/label.hpp>

int more();

int main(int argc, char * argv[])
{
  // Nobody uses this: a warning of g++ and of em++, which is no error in the page.
  int unused;
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<rclcpp::Node>("report");
  const auto label = robot_extras::label(ROBOT_VERSION);
  RCLCPP_INFO(node->get_logger(), "%d tools, %s", more(), label.data.c_str());
  rclcpp::shutdown();
}
