// Calls /flip, waits for the answer, and so on; prints the time of each call in ms. Argument: calls.
#include <chrono>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "std_srvs/srv/set_bool.hpp"

using std::chrono::steady_clock;
using std_srvs::srv::SetBool;

int main(int argc, char * argv[])
{
  const auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  const auto calls = std::stoul(words.at(1));

  auto node = std::make_shared<rclcpp::Node>("call");
  auto client = node->create_client<SetBool>("flip");
  client->wait_for_service();
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  auto request = std::make_shared<SetBool::Request>();
  std::vector<double> times;
  while (times.size() < calls) {
    request->data = !request->data;
    const auto sent = steady_clock::now();
    auto answer = client->async_send_request(request);
    executor.spin_until_future_complete(answer);
    times.push_back(std::chrono::duration<double, std::milli>(steady_clock::now() - sent).count());
    if (answer.get()->success == request->data) {throw std::runtime_error("a wrong answer");}
  }
  for (const double time : times) {std::printf("%.4f\n", time);}
  rclcpp::shutdown();
  return 0;
}
