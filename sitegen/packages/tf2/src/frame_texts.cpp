// The descriptions of frames, and the messages of exceptions.
#include <cstdio>
#include <string>
#include <vector>

#include "tf2/buffer_core.hpp"

namespace tf2
{
namespace
{

std::string three_digits(double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%.3f", value);
  return text;
}

}  // namespace

std::string BufferCore::between(
  const std::string & error, CompactFrameID target, CompactFrameID source) const
{
  return error + ", when looking up transform from frame [" + names_[source] + "] to frame [" +
         names_[target] + "]";
}

std::string BufferCore::unconnected(CompactFrameID target, CompactFrameID source) const
{
  return "Could not find a connection between '" + names_[target] + "' and '" + names_[source] +
         "' because they are not part of the same tree.Tf has two or more unconnected trees.";
}

std::string BufferCore::loop() const
{
  return "The tf tree is invalid because it contains a loop.\n" + frames_as_string() + "\n";
}

std::string BufferCore::frames_as_string() const
{
  std::string text;
  for (CompactFrameID frame = 1; frame < names_.size(); ++frame) {
    if (const auto * known = history(frame)) {
      text += "Frame " + names_[frame] + " exists with parent " + names_[known->parent()] + ".\n";
    }
  }
  return text;
}

std::string BufferCore::allFramesAsString() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return frames_as_string();
}

std::string BufferCore::allFramesAsYAML(TimePoint current_time) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (names_.size() == 1) {return "[]";}
  std::string text;
  for (CompactFrameID frame = 1; frame < names_.size(); ++frame) {
    const auto * known = history(frame);
    if (!known || known->size() == 0) {continue;}
    const double length = durationToSec(known->newest() - known->oldest());
    const std::string & authority = authorities_[frame];
    text += names_[frame] + ": \n";
    text += "  parent: '" + names_[known->parent()] + "'\n";
    text += "  broadcaster: '" + (authority.empty() ? "no recorded authority" : authority) + "'\n";
    text += "  rate: " + three_digits(known->size() / std::max(length, 1e-4)) + "\n";
    text += "  most_recent_transform: " + displayTimePoint(known->newest()) + "\n";
    text += "  oldest_transform: " + displayTimePoint(known->oldest()) + "\n";
    if (current_time != TimePointZero) {
      text += "  transform_delay: " + three_digits(durationToSec(current_time - known->newest()));
      text += "\n";
    }
    text += "  buffer_length: " + three_digits(length) + "\n";
  }
  return text;
}

}  // namespace tf2
