#include "rclcpp/node_interfaces/node_base_interface.hpp"

#include <stdexcept>
#include <utility>

#include "rclcpp/detail/host.h"
#include "rclcpp/detail/stacks.hpp"

namespace rclcpp
{
namespace node_interfaces
{

namespace
{

std::string with_slash(const std::string & name_space)
{
  return name_space.empty() || name_space[0] != '/' ? "/" + name_space : name_space;
}

}  // namespace

NodeBaseInterface::NodeBaseInterface(
  const std::string & name, const std::string & name_space, Context::SharedPtr context,
  detail::Arguments arguments)
: context_(std::move(context)), arguments_(std::move(arguments)),
  name_(detail::remap_node(arguments_, name, "__node", name)),
  namespace_(with_slash(detail::remap_node(arguments_, name, "__ns", name_space))),
  full_name_((namespace_ == "/" ? "/" : namespace_ + "/") + name_),
  id_(0),
  default_group_(create_callback_group(CallbackGroupType::MutuallyExclusive))
{
  detail::validate_node_name(name_);
  detail::validate_namespace(namespace_);
  const ros_qos none{};
  id_ = ros_create(ROS_NODE, full_name_.c_str(), "", "", &none);
}

NodeBaseInterface::~NodeBaseInterface() {ros_destroy(id_);}

CallbackGroup::SharedPtr NodeBaseInterface::create_callback_group(
  CallbackGroupType type, bool automatically_add_to_executor_with_node)
{
  auto group = std::make_shared<CallbackGroup>(type, automatically_add_to_executor_with_node);
  groups_.push_back(group);
  return group;
}

bool NodeBaseInterface::callback_group_in_node(CallbackGroup::SharedPtr group)
{
  bool found = false;
  for_each_callback_group([&](const CallbackGroup::SharedPtr & one) {found |= one == group;});
  return found;
}

void NodeBaseInterface::for_each_callback_group(const CallbackGroupFunction & function)
{
  const auto groups = groups_;
  for (const auto & group : groups) {
    if (auto living = group.lock()) {function(std::move(living));}
  }
}

std::string NodeBaseInterface::resolve_topic_or_service_name(
  const std::string & name, bool is_service, bool only_expand) const
{
  const auto kind = is_service ? detail::NameKind::Service : detail::NameKind::Topic;
  return only_expand ? detail::expand_name(name_, namespace_, name, kind) : resolve(name, kind);
}

std::string NodeBaseInterface::resolve(
  const std::string & name, detail::NameKind kind) const
{
  return detail::resolve_name(arguments_, name_, namespace_, name, kind);
}

void NodeBaseInterface::add(
  detail::ExecutableKind kind, std::weak_ptr<detail::Executable> executable,
  CallbackGroup::SharedPtr group)
{
  if (group && !callback_group_in_node(group)) {
    throw std::runtime_error("Cannot create entity, callback group not in node.");
  }
  (group ? group : default_group_)->add(kind, std::move(executable));
  detail::wake();
}

}  // namespace node_interfaces
}  // namespace rclcpp
