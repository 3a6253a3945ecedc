#include "parameter_overrides.hpp"

#include <algorithm>
#include <utility>

#include "rclcpp/detail/parameter_text.hpp"

namespace rclcpp
{
namespace detail
{

namespace
{

using Overrides = std::map<std::string, ParameterValue>;
using Rules = std::vector<ParameterRule>::const_iterator;

/// Take a later value, unless the one that is there is of a type that rcl prefers: it keeps a value
/// of each type, and the first in the order of types counts.
void keep(ParameterValue & kept, ParameterValue value)
{
  const bool is_first = kept.get_type() == PARAMETER_NOT_SET;
  const bool is_set = value.get_type() != PARAMETER_NOT_SET;
  if (is_first || (is_set && value.get_type() <= kept.get_type())) {kept = std::move(value);}
}

/// Add the parameters of `rules`. Patterns count in the order in which they first appear.
void add(Overrides & overrides, Rules begin, Rules end, const std::string & full_name)
{
  for (Rules rule = begin; rule != end; ++rule) {
    const auto is_same = [rule](const ParameterRule & one) {return one.node == rule->node;};
    const bool is_known = std::any_of(begin, rule, is_same);
    if (is_known || !applies_to(rule->node, full_name)) {continue;}
    Overrides values;
    for (Rules one = rule; one != end; ++one) {
      if (is_same(*one)) {keep(values[one->name], parse_parameter(one->value));}
    }
    for (auto & [name, value] : values) {overrides[name] = std::move(value);}
  }
}

}  // namespace

std::map<std::string, ParameterValue> overrides_of(
  const Arguments & arguments, const std::string & full_name)
{
  Overrides overrides;
  const Rules own = arguments.parameters.begin() +
    static_cast<std::ptrdiff_t>(arguments.own_parameters_from);
  add(overrides, arguments.parameters.begin(), own, full_name);
  add(overrides, own, arguments.parameters.end(), full_name);
  return overrides;
}

}  // namespace detail
}  // namespace rclcpp
