// The only place where the program waits; all blocking functions use it.
#pragma once

#include <cstdint>
#include <functional>

namespace rclcpp
{
namespace detail
{

/// Milliseconds since 1970; never decreases.
double now();

/// Convert `milliseconds` to whole nanoseconds. A single product of doubles would be off by up to a
/// quarter of a microsecond for times since 1970, which would also distort differences.
std::int64_t nanoseconds(double milliseconds);

/// Suspend the caller until something happens in the graph, at most `milliseconds` (0: one turn of
/// the event loop; negative: no limit). Raises a signal that has arrived before it returns.
void wait(double milliseconds);

/// Yield to the event loop if the program has not done so for a while, for messages and Stop.
void breathe();

/// Whether the program is ending: functions that run at exit() must not wait.
bool is_ending();

/// Run `body`; an uncaught exception ends the program with its message.
void guarded(const std::function<void()> & body);

/// Suspend the caller until `milliseconds` have passed, whatever happens in the graph, or until
/// `stop` returns true.
void sleep(double milliseconds, const std::function<bool()> & stop);

}  // namespace detail
}  // namespace rclcpp
