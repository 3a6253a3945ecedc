#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp/callback_group.hpp"
#include "rclcpp/context.hpp"
#include "rclcpp/detail/names.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{
namespace node_interfaces
{

/// The interface that executors use: the name of the node and its callback groups.
class NodeBaseInterface : public std::enable_shared_from_this<NodeBaseInterface>
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeBaseInterface)
  RCLCPP_DISABLE_COPY(NodeBaseInterface)

  using CallbackGroupFunction = std::function<void (CallbackGroup::SharedPtr)>;

  /// Apply the remap rules of `arguments`, then those of `context`, and join the graph.
  NodeBaseInterface(
    const std::string & name, const std::string & name_space, Context::SharedPtr context,
    detail::Arguments arguments);
  ~NodeBaseInterface();

  const char * get_name() const {return name_.c_str();}
  const char * get_namespace() const {return namespace_.c_str();}
  const char * get_fully_qualified_name() const {return full_name_.c_str();}
  Context::SharedPtr get_context() const {return context_;}
  /// Returns itself, so that it can be used in place of a node.
  SharedPtr get_node_base_interface() {return shared_from_this();}

  CallbackGroup::SharedPtr create_callback_group(
    CallbackGroupType type, bool automatically_add_to_executor_with_node = true);
  CallbackGroup::SharedPtr get_default_callback_group() const {return default_group_;}
  bool callback_group_in_node(CallbackGroup::SharedPtr group);
  void for_each_callback_group(const CallbackGroupFunction & function);
  std::atomic_bool & get_associated_with_executor_atomic() {return associated_;}

  std::string resolve_topic_or_service_name(
    const std::string & name, bool is_service, bool only_expand = false) const;
  /// Expand the name of a topic or service of this node, and apply the remap rules.
  std::string resolve(const std::string & name, detail::NameKind kind) const;
  const detail::Arguments & arguments() const {return arguments_;}

  /// Add `executable` to `group` or to the default group. Throws std::runtime_error if the group
  /// belongs to another node.
  void add(
    detail::ExecutableKind kind, std::weak_ptr<detail::Executable> executable,
    CallbackGroup::SharedPtr group = nullptr);

private:
  Context::SharedPtr context_;
  detail::Arguments arguments_;
  std::string name_;
  std::string namespace_;
  std::string full_name_;
  std::int32_t id_;
  std::atomic_bool associated_{false};
  std::vector<std::weak_ptr<CallbackGroup>> groups_;
  CallbackGroup::SharedPtr default_group_;  // one of them
};

}  // namespace node_interfaces
}  // namespace rclcpp
