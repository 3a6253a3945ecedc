// Calls /divide with the two numbers of its command line, in the manner of a first service client.
#include <chrono>
#include <cstdlib>
#include <memory>

#include "calc_interfaces/srv/divide.hpp"
#include "rclcpp/rclcpp.hpp"

using namespace std::chrono_literals;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  if (argc < 3) {
    RCLCPP_ERROR(rclcpp::get_logger("client"), "usage: client DIVIDEND DIVISOR");
    return 1;
  }
  auto node = rclcpp::Node::make_shared("divide_client");
  auto client = node->create_client<calc_interfaces::srv::Divide>("divide");
  auto request = std::make_shared<calc_interfaces::srv::Divide::Request>();
  request->dividend = std::atof(argv[1]);
  request->divisor = std::atof(argv[2]);

  while (!client->wait_for_service(100ms)) {
    if (!rclcpp::ok()) {
      RCLCPP_ERROR(node->get_logger(), "Interrupted while waiting for the service");
      return 0;
    }
    RCLCPP_INFO_ONCE(node->get_logger(), "No service yet, waiting");
  }

  auto result = client->async_send_request(request);
  if (rclcpp::spin_until_future_complete(node, result, 2s) == rclcpp::FutureReturnCode::SUCCESS) {
    const auto response = result.get();
    RCLCPP_INFO(
      node->get_logger(), "Quotient: %g%s", response->quotient, response->error.c_str());
  } else {
    RCLCPP_ERROR(node->get_logger(), "No answer");
  }
  rclcpp::shutdown();
  return 0;
}
