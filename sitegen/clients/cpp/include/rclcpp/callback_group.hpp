#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <vector>

#include "rclcpp/detail/executable.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{

enum class CallbackGroupType {MutuallyExclusive, Reentrant};

/// A group of callbacks that an executor runs one at a time, or in parallel if it is reentrant.
class CallbackGroup
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(CallbackGroup)
  RCLCPP_DISABLE_COPY(CallbackGroup)

  explicit CallbackGroup(
    CallbackGroupType type, bool automatically_add_to_executor_with_node = true)
  : type_(type), automatically_add_(automatically_add_to_executor_with_node) {}

  const CallbackGroupType & type() const {return type_;}
  /// False while a callback of a mutually exclusive group runs.
  std::atomic_bool & can_be_taken_from() {return can_be_taken_from_;}
  std::atomic_bool & get_associated_with_executor_atomic() {return associated_;}
  /// Allow callbacks to run again, and wake threads that skipped the group.
  void give_back();
  bool automatically_add_to_executor_with_node() const {return automatically_add_;}
  std::size_t size() const;

  void add(detail::ExecutableKind kind, std::weak_ptr<detail::Executable> executable);
  void remove(detail::ExecutableKind kind, const std::shared_ptr<detail::Executable> & executable);
  /// The existing entities of a kind; expired ones are removed.
  std::vector<std::shared_ptr<detail::Executable>> living(detail::ExecutableKind kind);

  /// Whether a thread skipped the group because it was busy.
  std::atomic_bool waited_for{false};

private:
  CallbackGroupType type_;
  bool automatically_add_;
  std::atomic_bool can_be_taken_from_{true};
  std::atomic_bool associated_{false};
  std::array<std::vector<std::weak_ptr<detail::Executable>>, detail::kExecutableKinds> members_;
};

}  // namespace rclcpp
