// The services that get and set logger levels.
#include <memory>
#include <string>
#include <utility>

#include "rcl_interfaces/srv/get_logger_levels.hpp"
#include "rcl_interfaces/srv/set_logger_levels.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/node_options.hpp"
#include "rclcpp/service.hpp"

namespace rclcpp
{
namespace detail
{

namespace
{

using Get = rcl_interfaces::srv::GetLoggerLevels;
using Set = rcl_interfaces::srv::SetLoggerLevels;

rcl_interfaces::msg::SetLoggerLevelsResult set(const rcl_interfaces::msg::LoggerLevel & given)
{
  rcl_interfaces::msg::SetLoggerLevelsResult result;
  result.successful = given.level % 10 == 0 && given.level <= 50;
  if (result.successful) {
    Logger(given.name).set_level(Logger::Level(given.level));
  } else {
    result.reason =
      "Unable to determine severity_string for severity " + std::to_string(given.level);
  }
  return result;
}

}  // namespace

std::shared_ptr<void> make_logger_services(node_interfaces::NodeBaseInterface & node)
{
  const auto get_levels = [](Get::Request::SharedPtr request, Get::Response::SharedPtr response) {
      for (const auto & name : request->names) {
        rcl_interfaces::msg::LoggerLevel found;
        found.name = name;
        found.level = static_cast<std::uint32_t>(own_level(Logger(name)));
        response->levels.push_back(found);
      }
    };
  const auto set_levels = [](Set::Request::SharedPtr request, Set::Response::SharedPtr response) {
      for (const auto & level : request->levels) {response->results.push_back(set(level));}
    };
  auto get = std::make_shared<Service<Get>>(
    node, "~/get_logger_levels", ServicesQoS(), get_levels);
  auto set = std::make_shared<Service<Set>>(
    node, "~/set_logger_levels", ServicesQoS(), set_levels);
  node.add(ExecutableKind::kService, get);
  node.add(ExecutableKind::kService, set);
  return std::make_shared<std::pair<ServiceBase::SharedPtr, ServiceBase::SharedPtr>>(get, set);
}

}  // namespace detail
}  // namespace rclcpp
