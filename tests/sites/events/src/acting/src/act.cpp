// A managed node that ends by itself after some seconds, with an exit code; 0 s is never.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

class Act : public rclcpp_lifecycle::LifecycleNode
{
public:
  Act()
  : LifecycleNode("act")
  {
    // With parameters, it follows simulated time.
    std::printf("%s\n", declare_parameter("greeting", "up").c_str());
  }

  CallbackReturn on_configure(const rclcpp_lifecycle::State &) override
  {
    std::printf("configured\n");
    return CallbackReturn::SUCCESS;
  }
  CallbackReturn on_activate(const rclcpp_lifecycle::State & state) override
  {
    std::printf("activated\n");
    return LifecycleNode::on_activate(state);
  }
  CallbackReturn on_cleanup(const rclcpp_lifecycle::State &) override
  {
    return CallbackReturn::FAILURE;
  }
};

int main(int argc, char ** argv)
{
  const auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  const double seconds = words.size() > 1 ? std::atof(words[1].c_str()) : 0;
  const int code = words.size() > 2 ? std::atoi(words[2].c_str()) : 0;
  auto act = std::make_shared<Act>();
  rclcpp::TimerBase::SharedPtr timer;
  if (seconds > 0) {
    timer = act->create_wall_timer(std::chrono::duration<double>(seconds), [] {rclcpp::shutdown();});
  }
  rclcpp::spin(act->get_node_base_interface());
  rclcpp::shutdown();
  return code;
}
