#include "rclcpp/detail/names.hpp"

#include <algorithm>
#include <cctype>

#include "rclcpp/exceptions.hpp"

namespace rclcpp
{

namespace exceptions
{

NameValidationError::NameValidationError(
  const char * name_type, const char * name, const char * error_msg, std::size_t invalid_index)
: std::invalid_argument(
    std::string("Invalid ") + name_type + ": " + error_msg + ":\n  '" + name + "'\n   " +
    std::string(invalid_index, ' ') + "^\n"),
  name_type(name_type), name(name), error_msg(error_msg), invalid_index(invalid_index)
{
}

}  // namespace exceptions

namespace detail
{

namespace
{

constexpr std::size_t kLongestNode = 255;
// Middlewares add a prefix or suffix of up to eight characters.
constexpr std::size_t kLongestTopic = 255 - 8;

struct Fault
{
  const char * what = nullptr;
  std::size_t where = 0;
};

bool is_word(char c) {return std::isalnum(static_cast<unsigned char>(c)) || c == '_';}
bool is_digit(char c) {return std::isdigit(static_cast<unsigned char>(c));}

/// The position of the first character from `begin` on that `allowed` rejects.
template<class AllowedT>
std::size_t find_not(const std::string & name, AllowedT allowed, std::size_t begin = 0)
{
  const auto found = std::find_if_not(
    name.begin() + static_cast<std::ptrdiff_t>(begin), name.end(), allowed);
  return found == name.end() ? std::string::npos : static_cast<std::size_t>(found - name.begin());
}

std::size_t find_token_with_digit(const std::string & name)
{
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (is_digit(name[i]) && (i == 0 || name[i - 1] == '/')) {return i;}
  }
  return std::string::npos;
}

Fault fault_of_node_name(const std::string & name)
{
  if (name.empty()) {return {"node name must not be empty", 0};}
  if (const auto at = find_not(name, is_word); at != std::string::npos) {
    return {"node name must not contain characters other than alphanumerics or '_'", at};
  }
  if (is_digit(name[0])) {return {"node name must not start with a number", 0};}
  if (name.size() > kLongestNode) {
    return {"node name length should not exceed '255'", kLongestNode - 1};
  }
  return {};
}

Fault fault_of_namespace(const std::string & name)
{
  if (name == "/") {return {};}
  if (name.back() == '/') {
    return {"namespace must not end with a '/', unless only a '/'", name.size() - 1};
  }
  const auto allowed = [](char c) {return is_word(c) || c == '/';};
  if (const auto at = find_not(name, allowed); at != std::string::npos) {
    return {"namespace must not contain characters other than alphanumerics, '_', or '/'", at};
  }
  if (const auto at = name.find("//"); at != std::string::npos) {
    return {"namespace must not contain repeated '/'", at + 1};
  }
  if (const auto at = find_token_with_digit(name); at != std::string::npos) {
    return {"namespace must not have a token that starts with a number", at};
  }
  if (name.size() > kLongestTopic - 2) {
    return {"namespace should not exceed 'RMW_NAMESPACE_MAX_NAME_LENGTH'", kLongestTopic - 3};
  }
  return {};
}

/// The fault of a name before expansion.
Fault fault_of_topic_name(const std::string & name)
{
  if (name.empty()) {return {"topic name must not be empty string", 0};}
  if (name.back() == '/') {
    return {"topic name must not end with a forward slash", name.size() - 1};
  }
  const auto open = std::string::npos;
  std::size_t brace = open;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (c == '}' && brace == open) {
      return {"topic name must not have unmatched (unbalanced) curly braces '{}'", i};
    } else if (c == '}') {
      brace = open;
    } else if (brace != open && !is_word(c)) {
      return {
        "substitution name must not contain characters other than alphanumerics or '_'", i};
    } else if (c == '{') {
      brace = i;
    } else if (c == '~' && i > 0) {
      return {"topic name must not have tilde '~' unless it is the first character", i};
    } else if (!is_word(c) && c != '/' && c != '~') {
      return {
        "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'",
        i};
    }
  }
  if (brace != open) {
    return {"topic name must not have unmatched (unbalanced) curly braces '{}'", brace};
  }
  if (const auto at = find_token_with_digit(name); at != std::string::npos) {
    return {"topic name token must not start with a number", at};
  }
  return {};
}

Fault fault_of_full_name(const std::string & name)
{
  if (const auto at = name.find("//"); at != std::string::npos) {
    return {"topic name must not contain repeated '/'", at + 1};
  }
  if (const auto at = find_token_with_digit(name); at != std::string::npos) {
    return {"topic name must not have a token that starts with a number", at};
  }
  if (name.size() > kLongestTopic) {
    return {"topic length should not exceed '255U - 8U'", kLongestTopic - 1};
  }
  return {};
}

void refuse(const Fault & fault, const std::string & name, NameKind kind)
{
  if (!fault.what) {return;}
  if (kind == NameKind::Service) {
    throw exceptions::InvalidServiceNameError(name.c_str(), fault.what, fault.where);
  }
  throw exceptions::InvalidTopicNameError(name.c_str(), fault.what, fault.where);
}

std::string join(const std::string & name_space, const std::string & name)
{
  return (name_space == "/" ? name_space : name_space + "/") + name;
}

/// Replace substitutions in braces.
std::string substitute(
  const std::string & node, const std::string & name_space, const std::string & name)
{
  std::string filled;
  std::size_t at = 0;
  for (std::size_t brace; (brace = name.find('{', at)) != std::string::npos;) {
    const auto end = name.find('}', brace) + 1;
    const std::string what = name.substr(brace, end - brace);
    filled += name.substr(at, brace - at);
    if (what == "{node}") {
      filled += node;
    } else if (what == "{ns}" || what == "{namespace}") {
      filled += name_space;
    } else {
      throw exceptions::RCLError(
              "topic name '" + name + "' is invalid: unknown substitution: " + what);
    }
    at = end;
  }
  return filled + name.substr(at);
}

}  // namespace

void validate_node_name(const std::string & name)
{
  const Fault fault = fault_of_node_name(name);
  if (fault.what) {
    throw exceptions::InvalidNodeNameError(name.c_str(), fault.what, fault.where);
  }
}

void validate_namespace(const std::string & name_space)
{
  const Fault fault = fault_of_namespace(name_space);
  if (fault.what) {
    throw exceptions::InvalidNamespaceError(name_space.c_str(), fault.what, fault.where);
  }
}

std::string expand_name(
  const std::string & node, const std::string & name_space, const std::string & name,
  NameKind kind)
{
  refuse(fault_of_topic_name(name), name, kind);
  std::string full = substitute(node, name_space, name);
  if (full[0] == '~') {
    full = join(name_space, node) + full.substr(1);
  } else if (full[0] != '/') {
    full = join(name_space, full);
  }
  refuse(fault_of_full_name(full), full, kind);
  return full;
}

std::string logger_name(std::string full_node_name)
{
  std::replace(full_node_name.begin(), full_node_name.end(), '/', '.');
  return full_node_name.substr(1);
}

}  // namespace detail
}  // namespace rclcpp
