// Serves /add_two_ints.
#include <cinttypes>
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "tutorial_interfaces/srv/add_two_ints.hpp"

using tutorial_interfaces::srv::AddTwoInts;

void add(
  const std::shared_ptr<AddTwoInts::Request> request,
  std::shared_ptr<AddTwoInts::Response> response)
{
  response->sum = request->a + request->b;
  RCLCPP_INFO(
    rclcpp::get_logger("add_two_ints_server"), "%" PRId64 " + %" PRId64 " = %" PRId64,
    request->a, request->b, response->sum);
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("add_two_ints_server");
  auto service = node->create_service<AddTwoInts>("add_two_ints", &add);

  RCLCPP_INFO(node->get_logger(), "Ready to add two numbers");
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
