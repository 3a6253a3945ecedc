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

/// Callbacks of which an executor with several threads runs one at a time, or as many as it likes.
class CallbackGroup
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(CallbackGroup)
  RCLCPP_DISABLE_COPY(CallbackGroup)

  explicit CallbackGroup(
    CallbackGroupType type, bool automatically_add_to_executor_with_node = true)
  : type_(type), automatically_add_(automatically_add_to_executor_with_node) {}

  const CallbackGroupType & type() const {return type_;}
  /// False while one of its callbacks runs that excludes the others.
  std::atomic_bool & can_be_taken_from() {return can_be_taken_from_;}
  std::atomic_bool & get_associated_with_executor_atomic() {return associated_;}
  /// Let callbacks of it run again, by those too who passed it by.
  void give_back();
  bool automatically_add_to_executor_with_node() const {return automatically_add_;}
  std::size_t size() const;

  void add(detail::ExecutableKind kind, std::weak_ptr<detail::Executable> executable);
  void remove(detail::ExecutableKind kind, const std::shared_ptr<detail::Executable> & executable);
  /// The living ones of a kind; those that are gone leave the group.
  std::vector<std::shared_ptr<detail::Executable>> living(detail::ExecutableKind kind);

  /// Whether some thread passed it by because it was taken.
  std::atomic_bool waited_for{false};

private:
  CallbackGroupType type_;
  bool automatically_add_;
  std::atomic_bool can_be_taken_from_{true};
  std::atomic_bool associated_{false};
  std::array<std::vector<std::weak_ptr<detail::Executable>>, detail::kExecutableKinds> members_;
};

}  // namespace rclcpp
