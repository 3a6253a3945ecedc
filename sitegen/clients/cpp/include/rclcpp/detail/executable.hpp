// An entity whose callbacks an executor calls.
#pragma once

#include <cstdint>

namespace rclcpp
{
namespace detail
{

/// The order in which executors look, as rcl's wait sets have it.
enum class ExecutableKind {kTimer, kSubscription, kService, kClient, kWaitable};
constexpr int kExecutableKinds = 5;

class Executable
{
public:
  virtual ~Executable() = default;

  /// Call back for one thing that is ready; false if nothing was.
  virtual bool execute_one() = 0;
  /// Nanoseconds until it will be ready by the clock alone; INT64_MAX if that is not known.
  virtual std::int64_t time_left() const {return INT64_MAX;}
};

}  // namespace detail
}  // namespace rclcpp
