// The topic /rosout, to which each node publishes its log.
#pragma once

#include <memory>
#include <string>

#include "rclcpp/node_interfaces/node_base_interface.hpp"

namespace rclcpp
{
namespace detail
{

/// Publishes what is logged under the name of a node, and below it, as long as it lives.
class Rosout
{
public:
  Rosout(const node_interfaces::NodeBaseInterface & node, const std::string & logger);
  ~Rosout();

private:
  std::string logger_;
};

/// Publish a line of the log, if a node's logger or one above it has that name. `stamp` is in
/// milliseconds since 1970.
void publish_rosout(
  int severity, const std::string & logger, const std::string & text, double stamp);

}  // namespace detail
}  // namespace rclcpp
