// Tries the names that come as arguments, after a letter for what they name, and tells what became of
// each.
#include <iostream>
#include <memory>
#include <string>

#include "example_interfaces/srv/add_two_ints.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

namespace
{

std::string outcome(const rclcpp::Node::SharedPtr & node, char what, const std::string & name)
{
  using example_interfaces::srv::AddTwoInts;
  switch (what) {
    case 'n': return rclcpp::Node(name).get_fully_qualified_name();
    case 's': return rclcpp::Node("node", name).get_fully_qualified_name();
    case 't': return node->create_publisher<std_msgs::msg::String>(name, 1)->get_topic_name();
    default: return node->create_client<AddTwoInts>(name)->get_service_name();
  }
}

}  // namespace

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("talker", "space");
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    try {
      std::cout << outcome(node, argument[0], argument.substr(2)) << std::endl;
    } catch (const std::exception & error) {
      std::cout << error.what() << std::endl;
    }
    std::cout << "--" << std::endl;
  }
  rclcpp::shutdown();
  return 0;
}
