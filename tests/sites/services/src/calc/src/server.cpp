// Serves /divide, and /patience, which it answers when /enough is called.
#include <memory>
#include <utility>
#include <vector>

#include "calc_interfaces/srv/divide.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_srvs/srv/trigger.hpp"

using calc_interfaces::srv::Divide;
using std_srvs::srv::Trigger;

void divide(
  const std::shared_ptr<Divide::Request> request, std::shared_ptr<Divide::Response> response)
{
  if (request->divisor == 0) {
    response->error = "division by zero";
    return;
  }
  response->quotient = request->dividend / request->divisor;
  RCLCPP_INFO(
    rclcpp::get_logger("server"), "%g / %g", request->dividend, request->divisor);
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("divide_server");
  auto service = node->create_service<Divide>("divide", &divide);

  std::vector<std::shared_ptr<rmw_request_id_t>> waiting;
  auto patience = node->create_service<Trigger>(
    "patience",
    [&waiting](std::shared_ptr<rmw_request_id_t> id, std::shared_ptr<Trigger::Request>) {
      waiting.push_back(std::move(id));
    });
  auto enough = node->create_service<Trigger>(
    "enough", [&](Trigger::Request::SharedPtr, Trigger::Response::SharedPtr) {
      for (const auto & id : waiting) {
        Trigger::Response response;
        response.success = true;
        response.message = "at last";
        patience->send_response(*id, response);
      }
      waiting.clear();
    });

  RCLCPP_INFO(node->get_logger(), "Ready on %s", service->get_service_name());
  rclcpp::spin(node);
  rclcpp::shutdown();
}
