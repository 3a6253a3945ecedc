#include "rclcpp/detail/rosout.hpp"

#include <map>

#include "rcl_interfaces/msg/log.hpp"
#include "rclcpp/detail/platform.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/time.hpp"

namespace rclcpp
{
namespace detail
{

namespace
{

using Log = rcl_interfaces::msg::Log;

// Never destroyed: nodes with static lifetime still log while the program exits.
std::map<std::string, std::unique_ptr<Publisher<Log>>> & publishers()
{
  static auto * publishers = new std::map<std::string, std::unique_ptr<Publisher<Log>>>;
  return *publishers;
}

/// The publisher of the node to which `logger` belongs: its own, or that of the nearest name above.
Publisher<Log> * find(std::string logger)
{
  while (true) {
    const auto found = publishers().find(logger);
    if (found != publishers().end()) {return found->second.get();}
    const auto dot = logger.rfind('.');
    if (dot == std::string::npos) {return nullptr;}
    logger.erase(dot);
  }
}

}  // namespace

Rosout::Rosout(const node_interfaces::NodeBaseInterface & node, const std::string & logger)
: logger_(logger)
{
  publishers().try_emplace(
    logger, std::make_unique<Publisher<Log>>(node, "/rosout", RosoutQoS()));
}

Rosout::~Rosout() {publishers().erase(logger_);}

void publish_rosout(
  int severity, const std::string & logger, const std::string & text, double stamp)
{
  const auto publisher = find(logger);
  if (!publisher) {return;}
  Log line;
  line.stamp = Time(nanoseconds(stamp));
  line.level = static_cast<std::uint8_t>(severity);
  line.name = logger;
  line.msg = text;
  publisher->publish(line);
}

}  // namespace detail
}  // namespace rclcpp
