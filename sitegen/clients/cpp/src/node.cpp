#include "rclcpp/node.hpp"

#include "rclcpp/detail/arguments.hpp"
#include "rclcpp/detail/host.h"

namespace rclcpp
{

namespace
{

std::string with_slash(const std::string & name_space)
{
  return name_space.empty() || name_space[0] != '/' ? "/" + name_space : name_space;
}

}  // namespace

namespace node_interfaces
{

NodeBaseInterface::NodeBaseInterface(const std::string & name, const std::string & name_space)
: name_(detail::remap_node(detail::arguments(), name, "__node", name)),
  namespace_(
    with_slash(detail::remap_node(detail::arguments(), name, "__ns", name_space))),
  full_name_((namespace_ == "/" ? "/" : namespace_ + "/") + name_),
  id_(0)
{
  detail::validate_node_name(name_);
  detail::validate_namespace(namespace_);
  const ros_qos none{};
  id_ = ros_create(ROS_NODE, full_name_.c_str(), "", "", &none);
}

NodeBaseInterface::~NodeBaseInterface() {ros_destroy(id_);}

std::string NodeBaseInterface::resolve(
  const std::string & name, detail::NameKind kind) const
{
  return detail::resolve_name(detail::arguments(), name_, namespace_, name, kind);
}

}  // namespace node_interfaces

Node::Node(const std::string & name, const NodeOptions & options)
: Node(name, "", options)
{
}

Node::Node(const std::string & name, const std::string & name_space, const NodeOptions &)
: base_(std::make_shared<node_interfaces::NodeBaseInterface>(name, name_space)),
  logger_(detail::logger_name(base_->get_fully_qualified_name())),
  rosout_(*base_, logger_.get_name()),
  clock_(std::make_shared<Clock>(RCL_ROS_TIME))
{
}

}  // namespace rclcpp
