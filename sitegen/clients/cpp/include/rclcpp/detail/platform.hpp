// The only place where the program waits; all blocking functions use it.
#pragma once

#include <cstdint>
#include <functional>

namespace rclcpp
{
namespace detail
{

/// Milliseconds since 1970; never steps back.
double now();

/// The whole nanoseconds of `milliseconds`. The product as one double would be a quarter of a
/// microsecond off for times since 1970, and then two times further apart than they are, or nearer.
std::int64_t nanoseconds(double milliseconds);

/// Suspend the caller until something happened in the graph, at most `milliseconds` (0: let the
/// event loop turn once; negative: no limit). A signal that came is raised before it returns.
void wait(double milliseconds);

/// Let the event loop turn when it has not for a while: messages and Stop come by it.
void breathe();

/// Run `body`; an exception that leaves it ends the program with its text.
void guarded(const std::function<void()> & body);

/// Suspend the caller until `milliseconds` passed, whatever happens in the graph, or until
/// `stop` says so.
void sleep(double milliseconds, const std::function<bool()> & stop);

}  // namespace detail
}  // namespace rclcpp
