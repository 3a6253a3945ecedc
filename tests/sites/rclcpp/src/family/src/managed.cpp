// A managed node, driven from inside and over its services by another.
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include "lifecycle_msgs/srv/change_state.hpp"
#include "lifecycle_msgs/srv/get_state.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "rclcpp_lifecycle/lifecycle_publisher.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;
using lifecycle_msgs::msg::Transition;

class Managed : public rclcpp_lifecycle::LifecycleNode
{
public:
  Managed()
  : LifecycleNode("managed") {}

  CallbackReturn on_configure(const rclcpp_lifecycle::State & state) override
  {
    std::printf("configure from %s\n", state.label().c_str());
    publisher_ = create_publisher<std_msgs::msg::String>("lifecycle_chatter", 10);
    return CallbackReturn::SUCCESS;
  }
  CallbackReturn on_activate(const rclcpp_lifecycle::State & state) override
  {
    LifecycleNode::on_activate(state);
    return ++activations_ == 2 ? CallbackReturn::FAILURE : CallbackReturn::SUCCESS;
  }
  CallbackReturn on_cleanup(const rclcpp_lifecycle::State &) override
  {
    throw std::runtime_error("stuck");
  }
  CallbackReturn on_error(const rclcpp_lifecycle::State &) override
  {
    return CallbackReturn::SUCCESS;
  }
  void say(const char * text)
  {
    std_msgs::msg::String message;
    message.data = text;
    publisher_->publish(message);
  }

private:
  int activations_ = 0;
  rclcpp_lifecycle::LifecyclePublisher<std_msgs::msg::String>::SharedPtr publisher_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto managed = std::make_shared<Managed>();
  auto driver = std::make_shared<rclcpp::Node>("driver");
  auto change = driver->create_client<lifecycle_msgs::srv::ChangeState>("managed/change_state");
  auto state = driver->create_client<lifecycle_msgs::srv::GetState>("managed/get_state");
  auto heard = driver->create_subscription<std_msgs::msg::String>(
    "lifecycle_chatter", 10,
    [](const std_msgs::msg::String & message) {std::printf("heard %s\n", message.data.c_str());});
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(managed->get_node_base_interface());
  executor.add_node(driver);

  const auto drive = [&](std::uint8_t id) {
      auto request = std::make_shared<lifecycle_msgs::srv::ChangeState::Request>();
      request->transition.id = id;
      auto changed = change->async_send_request(request);
      executor.spin_until_future_complete(changed);
      auto asked = state->async_send_request(
        std::make_shared<lifecycle_msgs::srv::GetState::Request>());
      executor.spin_until_future_complete(asked);
      std::printf("%d %s\n", changed.get()->success, asked.get()->current_state.label.c_str());
    };
  drive(Transition::TRANSITION_CONFIGURE);
  managed->say("too early");
  drive(Transition::TRANSITION_ACTIVATE);
  managed->say("in time");
  executor.spin_some();
  drive(Transition::TRANSITION_CONFIGURE);
  drive(Transition::TRANSITION_DEACTIVATE);
  managed->say("too late");
  executor.spin_some();
  drive(Transition::TRANSITION_ACTIVATE);
  drive(Transition::TRANSITION_CLEANUP);
  std::printf("%zu transitions\n", managed->get_available_transitions().size());
  std::printf("%s\n", managed->shutdown().label().c_str());
  rclcpp::shutdown();
}
