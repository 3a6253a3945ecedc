// The ROS arguments of the command line, and the names that they remap.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "rclcpp/detail/names.hpp"

namespace rclcpp
{
namespace detail
{

/// `--ros-args -r [node:]from:=to`
struct RemapRule
{
  std::string node;  // empty: of every node
  std::string from;
  std::string to;
};

/// `--ros-args -p [node:]name:=value`
struct ParameterRule
{
  std::string node;  // empty: of every node
  std::string name;
  std::string value;
};

struct Arguments
{
  std::vector<RemapRule> remaps;
  std::vector<ParameterRule> parameters;
  /// Where the rules of the node begin, which come after those of the program.
  std::size_t own_parameters_from = 0;
  std::map<std::string, int> log_levels;  // by logger, "" for all others
  std::vector<std::string> others;        // what is not for ROS

  /// Append the rules of `later`, which have a lower precedence.
  void append(const Arguments & later);
};

/// Parse a command line. Throws UnknownROSArgsError for arguments that this release does not know.
Arguments parse_arguments(int argc, char const * const * argv);

/// Whether a rule for `rule` applies to the node with this name: it is the name, or a pattern such
/// as `/**` or `/arm/*/gripper`.
bool applies_to(const std::string & rule, const std::string & full_name);

/// The value of the rule for `from`, "__node" or "__ns", that applies to the node `node`; else
/// `name`.
std::string remap_node(
  const Arguments & arguments, const std::string & node, const std::string & from,
  const std::string & name);

/// Expand the name of a topic or service of `node` in `name_space`, and apply the remap rules.
std::string resolve_name(
  const Arguments & arguments, const std::string & node, const std::string & name_space,
  const std::string & name, NameKind kind);

}  // namespace detail
}  // namespace rclcpp
