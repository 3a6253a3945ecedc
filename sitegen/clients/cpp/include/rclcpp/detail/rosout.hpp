// The topic /rosout, to which each node publishes its log.
#pragma once

#include <memory>
#include <string>

#include "rclcpp/node_interfaces/node_base_interface.hpp"

namespace rclcpp
{
namespace detail
{

/// Publishes the log of a node and of its child loggers during its lifetime.
class Rosout
{
public:
  Rosout(const node_interfaces::NodeBaseInterface & node, const std::string & logger);
  ~Rosout();

private:
  std::string logger_;
};

/// Publish a log message if its logger, or one of its parents, belongs to a node. `stamp` is in
/// milliseconds since 1970.
void publish_rosout(
  int severity, const std::string & logger, const std::string & text, double stamp);

}  // namespace detail
}  // namespace rclcpp
