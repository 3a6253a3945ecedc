// A server and its client in one program, with a service of the official tutorials.
#include <memory>

#include "example_interfaces/srv/add_two_ints.hpp"
#include "rclcpp/rclcpp.hpp"

using example_interfaces::srv::AddTwoInts;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("adder");
  auto service = node->create_service<AddTwoInts>(
    "add_two_ints",
    [](const AddTwoInts::Request::SharedPtr request, AddTwoInts::Response::SharedPtr response) {
      response->sum = request->a + request->b;
    });
  auto client = node->create_client<AddTwoInts>("add_two_ints");
  client->wait_for_service();
  auto request = std::make_shared<AddTwoInts::Request>();
  request->a = 40;
  request->b = 2;
  auto result = client->async_send_request(request);
  rclcpp::spin_until_future_complete(node, result);
  RCLCPP_INFO(node->get_logger(), "Sum: %ld", result.get()->sum);
  rclcpp::shutdown();
  return 0;
}
