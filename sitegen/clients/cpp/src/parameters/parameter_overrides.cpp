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

/// Add the parameters of rules. Patterns count in the order in which they first appear. For one
/// pattern, a value does not replace one of a type that comes first in the order of types: rcl keeps
/// a value of each type, and the first of them counts.
void add(Overrides & overrides, Rules begin, Rules end, const std::string & full_name)
{
  for (Rules rule = begin; rule != end; ++rule) {
    const auto is_same = [rule](const ParameterRule & one) {return one.node == rule->node;};
    if (std::any_of(begin, rule, is_same) || !applies_to(rule->node, full_name)) {continue;}
    for (Rules one = rule; one != end; ++one) {
      if (!is_same(*one)) {continue;}
      const bool is_first = std::none_of(
        rule, one, [&](const auto & other) {return is_same(other) && other.name == one->name;});
      ParameterValue value = parse_parameter(one->value);
      ParameterValue & kept = overrides[one->name];
      const int type = value.get_type();
      const int kept_type = is_first ? PARAMETER_NOT_SET : kept.get_type();
      if (kept_type == PARAMETER_NOT_SET || (type && type <= kept_type)) {kept = std::move(value);}
    }
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
