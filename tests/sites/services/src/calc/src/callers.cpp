// Two callers of one service at once, a hundred calls each, and the other forms of a call.
#include <chrono>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "calc_interfaces/srv/divide.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_srvs/srv/trigger.hpp"

using namespace std::chrono_literals;
using Divide = calc_interfaces::srv::Divide;
using Client = rclcpp::Client<Divide>;

static int right = 0;
static int wrong = 0;

static void call(Client::SharedPtr client, double value)
{
  auto request = std::make_shared<Divide::Request>();
  request->dividend = value;
  request->divisor = 2;
  client->async_send_request(request, [value](Client::SharedFuture future) {
      ++(future.get()->quotient == value / 2 ? right : wrong);
    });
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("callers");
  auto one = node->create_client<Divide>("divide");
  auto two = node->create_client<Divide>("divide");
  one->wait_for_service();
  two->wait_for_service(60s);
  for (int i = 0; i < 100; ++i) {
    call(one, i);
    call(two, 1000 + i);
  }

  auto request = std::make_shared<Divide::Request>();
  std::promise<std::string> with_request;
  one->async_send_request(request, [&](Client::SharedFutureWithRequest future) {
      const auto [asked, answer] = future.get();
      with_request.set_value(std::to_string(asked->divisor) + answer->error);
    });
  auto text = with_request.get_future();
  rclcpp::spin_until_future_complete(node, text, 60s);

  const auto forgotten = one->async_send_request(request);
  const bool removed = one->remove_pending_request(forgotten);
  const bool again = one->remove_pending_request(forgotten.request_id);

  auto patience = node->create_client<std_srvs::srv::Trigger>("/patience");
  patience->wait_for_service();
  auto enough = node->create_client<std_srvs::srv::Trigger>("/enough");
  enough->wait_for_service();
  const auto plea = std::make_shared<std_srvs::srv::Trigger::Request>();
  auto answer = patience->async_send_request(plea);
  const auto early = rclcpp::spin_until_future_complete(node, answer, 1ms);
  enough->async_send_request(plea);
  const auto late = rclcpp::spin_until_future_complete(node, answer, 60s);

  RCLCPP_INFO(
    node->get_logger(), "right %d, wrong %d, %s, removed %d %d, early %d, late %d: %s", right, wrong,
    text.get().c_str(), removed, again, early == rclcpp::FutureReturnCode::TIMEOUT,
    late == rclcpp::FutureReturnCode::SUCCESS, answer.get()->message.c_str());

  // What is asked while nobody serves gets no answer, from nobody.
  auto nobody = node->create_client<Divide>("nobody");
  auto never = nobody->async_send_request(request);
  RCLCPP_INFO(
    node->get_logger(), "ready %d, answered %d", nobody->service_is_ready(),
    rclcpp::spin_until_future_complete(node, never, 50ms) == rclcpp::FutureReturnCode::SUCCESS);
  rclcpp::shutdown();
  return 0;
}
