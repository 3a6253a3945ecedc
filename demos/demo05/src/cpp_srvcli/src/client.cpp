// Asks /add_two_ints for the sum of the two numbers of its command line, and ends.
#include <chrono>
#include <cinttypes>
#include <cstdlib>
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "tutorial_interfaces/srv/add_two_ints.hpp"

using namespace std::chrono_literals;
using tutorial_interfaces::srv::AddTwoInts;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("add_two_ints_client");
  if (argc < 3) {
    RCLCPP_ERROR(node->get_logger(), "usage: client A B");
    return 1;
  }
  auto client = node->create_client<AddTwoInts>("add_two_ints");
  auto request = std::make_shared<AddTwoInts::Request>();
  request->a = std::atoll(argv[1]);
  request->b = std::atoll(argv[2]);

  while (!client->wait_for_service(1s)) {
    if (!rclcpp::ok()) {
      RCLCPP_ERROR(node->get_logger(), "Stopped while waiting for the service");
      return 0;
    }
    RCLCPP_INFO(node->get_logger(), "No service yet, waiting");
  }

  auto result = client->async_send_request(request);
  if (rclcpp::spin_until_future_complete(node, result) == rclcpp::FutureReturnCode::SUCCESS) {
    RCLCPP_INFO(node->get_logger(), "Sum: %" PRId64, result.get()->sum);
  } else {
    RCLCPP_ERROR(node->get_logger(), "No answer from add_two_ints");
  }

  rclcpp::shutdown();
  return 0;
}
