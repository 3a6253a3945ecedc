// The one place where the program waits; everything that blocks comes here.
#pragma once

namespace rclcpp
{
namespace detail
{

/// Milliseconds since 1970; never steps back.
double now();

/// Suspend the caller until something happened in the graph, at most `milliseconds` (0: let the
/// event loop turn once; negative: no limit). A signal that came is raised before it returns.
void wait(double milliseconds);

/// Suspend the caller until `milliseconds` passed, whatever happens in the graph, or until
/// `stop` says so.
void sleep(double milliseconds, bool (* stop)());

}  // namespace detail
}  // namespace rclcpp
