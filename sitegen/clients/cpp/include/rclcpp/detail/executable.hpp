// An entity whose callbacks an executor calls.
#pragma once

#include <cstdint>

namespace rclcpp
{
namespace detail
{

/// The order in which executors check entities, which is that of rcl's wait sets.
enum class ExecutableKind {kTimer, kSubscription, kService, kClient, kWaitable};
constexpr int kExecutableKinds = 5;

class Executable
{
public:
  virtual ~Executable() = default;

  /// Run the callback for one event; false if there was none.
  virtual bool execute_one() = 0;
  /// Nanoseconds until it will be ready by the clock alone; INT64_MAX if that is unknown.
  virtual std::int64_t time_left() const {return INT64_MAX;}
};

}  // namespace detail
}  // namespace rclcpp
