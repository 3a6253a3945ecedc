#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp/detail/names.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{

class PublisherBase;
class SubscriptionBase;
class TimerBase;

namespace detail
{
class Receiver;
}  // namespace detail

namespace node_interfaces
{

/// What an executor needs of a node: its name in the graph and what can become ready.
class NodeBaseInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeBaseInterface)
  RCLCPP_DISABLE_COPY(NodeBaseInterface)

  /// Apply the remap rules of the command line and enter the graph.
  NodeBaseInterface(const std::string & name, const std::string & name_space);
  ~NodeBaseInterface();

  const char * get_name() const {return name_.c_str();}
  const char * get_namespace() const {return namespace_.c_str();}
  const char * get_fully_qualified_name() const {return full_name_.c_str();}
  /// Expand the name of a topic or a service as this node sees it and apply the remap rules.
  std::string resolve(const std::string & name, detail::NameKind kind) const;

  std::vector<std::weak_ptr<PublisherBase>> publishers;
  std::vector<std::weak_ptr<TimerBase>> timers;
  std::vector<std::weak_ptr<SubscriptionBase>> subscriptions;
  std::vector<std::weak_ptr<detail::Receiver>> services;
  std::vector<std::weak_ptr<detail::Receiver>> clients;

private:
  std::string name_;
  std::string namespace_;
  std::string full_name_;
  std::int32_t id_;
};

}  // namespace node_interfaces
}  // namespace rclcpp
