#include <map>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "twins.hpp"

static const std::map<std::string, void (*)()> kScenarios = {
  {"actions", play_actions},
  {"parameters", play_parameters},
  {"policies", play_policies},
  {"services", play_services},
  {"times", play_times},
};

int main(int argc, char ** argv)
{
  const auto arguments = rclcpp::init_and_remove_ros_arguments(argc, argv);
  kScenarios.at(arguments.at(1))();
  rclcpp::shutdown();
}
