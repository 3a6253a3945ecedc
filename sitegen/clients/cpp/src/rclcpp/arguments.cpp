#include "rclcpp/detail/arguments.hpp"

#include <cstring>
#include <utility>

#include "rclcpp/exceptions.hpp"
#include "rclcpp/logger.hpp"

namespace rclcpp
{

namespace exceptions
{

static std::string unknown_message(const std::vector<std::string> & unknown)
{
  std::string text = "found unknown ROS arguments:";
  for (const auto & argument : unknown) {text += " '" + argument + "'";}
  return text;
}

UnknownROSArgsError::UnknownROSArgsError(std::vector<std::string> && unknown_ros_args_in)
: std::runtime_error(unknown_message(unknown_ros_args_in)),
  unknown_ros_args(std::move(unknown_ros_args_in))
{
}

}  // namespace exceptions

namespace detail
{

namespace
{

int level_number(const std::string & name)
{
  static const std::pair<const char *, int> kLevels[] = {
    {"unset", 0}, {"debug", 10}, {"info", 20}, {"warn", 30}, {"error", 40}, {"fatal", 50}};
  for (const auto & [known, number] : kLevels) {
    if (strcasecmp(name.c_str(), known) == 0) {return number;}
  }
  return -1;
}

bool parse_remap(const std::string & text, Arguments & arguments)
{
  const auto assign = text.find(":=");
  if (assign == std::string::npos) {return false;}
  std::string from = text.substr(0, assign);
  const auto colon = from.find(':');
  std::string node = colon == std::string::npos ? "" : from.substr(0, colon);
  if (colon != std::string::npos) {from.erase(0, colon + 1);}
  if (from == "__name") {from = "__node";}
  arguments.remaps.push_back({std::move(node), std::move(from), text.substr(assign + 2)});
  return true;
}

bool parse_parameter_rule(const std::string & text, Arguments & arguments)
{
  const auto assign = text.find(":=");
  if (assign == std::string::npos) {return false;}
  std::string name = text.substr(0, assign);
  const auto colon = name.find(':');
  std::string node = colon == std::string::npos ? "" : name.substr(0, colon);
  if (colon != std::string::npos) {name.erase(0, colon + 1);}
  arguments.parameters.push_back({std::move(node), std::move(name), text.substr(assign + 2)});
  return true;
}

bool parse_log_level(const std::string & text, Arguments & arguments)
{
  const auto assign = text.find(":=");
  const std::string logger = assign == std::string::npos ? "" : text.substr(0, assign);
  const int level = level_number(assign == std::string::npos ? text : text.substr(assign + 2));
  if (level >= 0) {arguments.log_levels[logger] = level;}
  return level >= 0;
}

/// Whether `word` is an option such as `--disable-rosout-logs`.
bool is_about_outputs(const char * word)
{
  std::size_t start = 0;
  for (const char * begin : {"--enable-", "--disable-"}) {
    const std::size_t size = std::strlen(begin);
    if (std::strncmp(word, begin, size) == 0) {start = size;}
  }
  const char * rest = word + start;
  return start && (std::strcmp(rest, "rosout-logs") == 0 || std::strcmp(rest, "stdout-logs") == 0 ||
         std::strcmp(rest, "external-lib-logs") == 0);
}

}  // namespace

void Arguments::append(const Arguments & later)
{
  for (const auto & rule : later.remaps) {remaps.push_back(RemapRule(rule));}
  own_parameters_from = later.parameters.size();
  auto all = later.parameters;
  for (auto & rule : parameters) {all.push_back(std::move(rule));}
  parameters = std::move(all);
}

Arguments parse_arguments(int argc, char const * const * argv)
{
  Arguments arguments;
  std::vector<std::string> unknown;
  bool ros = false;
  for (int i = 0; i < argc; ++i) {
    const std::string word = argv[i];
    const bool more = i + 1 < argc;
    if (word == "--ros-args") {
      ros = true;
    } else if (!ros) {
      arguments.others.push_back(word);
    } else if (word == "--") {
      ros = false;
    } else if ((word == "-r" || word == "--remap") && more && parse_remap(argv[i + 1], arguments)) {
      ++i;
    } else if ((word == "-p" || word == "--param") && more &&
      parse_parameter_rule(argv[i + 1], arguments))
    {
      ++i;
    } else if (is_about_outputs(argv[i])) {
      // The page determines where log messages go.
    } else if (word == "--enclave" || word == "-e") {
      i += more;
    } else if (word == "--log-level" && more && parse_log_level(argv[i + 1], arguments)) {
      ++i;
    } else {
      unknown.push_back(word);
    }
  }
  if (!unknown.empty()) {throw exceptions::UnknownROSArgsError(std::move(unknown));}
  return arguments;
}

namespace
{

/// Whether `name` matches a pattern in which `*` matches one part between slashes, `**` any number.
bool fits(const char * form, const char * name)
{
  while (*form == '/') {++form;}
  while (*name == '/') {++name;}
  const char * end = form + std::strcspn(form, "/");
  const char * rest = name + std::strcspn(name, "/");
  const std::size_t size = end - form;
  const auto is = [&](const char * text, std::size_t length) {
      return size == length && std::memcmp(form, text, length) == 0;
    };
  if (is("**", 2)) {return fits(end, name) || (*name && fits(form, rest));}
  if (size == 0 || !*name) {return size == 0 && !*name;}
  return (is("*", 1) || is(name, rest - name)) && fits(end, rest);
}

}  // namespace

bool applies_to(const std::string & rule, const std::string & full_name)
{
  return rule.empty() || fits(rule.c_str(), full_name.c_str());
}

std::string remap_node(
  const Arguments & arguments, const std::string & node, const std::string & from,
  const std::string & name)
{
  for (const auto & rule : arguments.remaps) {
    if (rule.from == from && (rule.node.empty() || rule.node == node)) {return rule.to;}
  }
  return name;
}

std::string resolve_name(
  const Arguments & arguments, const std::string & node, const std::string & name_space,
  const std::string & name, NameKind kind)
{
  const std::string full = expand_name(node, name_space, name, kind);
  for (const auto & rule : arguments.remaps) {
    const bool applies = rule.node.empty() || rule.node == node;
    if (!applies || rule.from.rfind("__", 0) == 0) {continue;}
    if (expand_name(node, name_space, rule.from, kind) == full) {
      return expand_name(node, name_space, rule.to, kind);
    }
  }
  return full;
}

}  // namespace detail
}  // namespace rclcpp
