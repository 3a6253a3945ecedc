// A parser for the subset of YAML in parameter files.
#pragma once

#include <string>
#include <vector>

namespace rclcpp
{
namespace detail
{

struct Yaml
{
  enum Kind {kEmpty, kScalar, kList, kMap};

  Kind kind = kEmpty;
  unsigned line = 0;
  bool quoted = false;      // a scalar that is text, whatever it looks like
  std::string key;          // where it is part of a map
  std::string text;         // of a scalar
  std::vector<Yaml> parts;  // of a list or a map, in their order
};

/// Parse one document: maps, lists, quoted, plain and block scalars, but no aliases, as in
/// parameter files of upstream. Throws exceptions::RCLError with the line.
Yaml read_yaml(const std::string & text);

}  // namespace detail
}  // namespace rclcpp
