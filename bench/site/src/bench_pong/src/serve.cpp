// Serves /flip: answers with the opposite.
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_srvs/srv/set_bool.hpp"

using std_srvs::srv::SetBool;

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("serve");
  auto service = node->create_service<SetBool>(
    "flip", [](std::shared_ptr<SetBool::Request> request, std::shared_ptr<SetBool::Response> response) {
      response->success = !request->data;
    });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
