#include "rclcpp/detail/yaml.hpp"

#include <utility>

#include "rclcpp/exceptions.hpp"
#include "yaml_text.hpp"

namespace rclcpp
{
namespace detail
{

namespace
{

Yaml block(YamlText & text, std::size_t least);
Yaml value(YamlText & text, std::size_t least, bool may_nest);

Yaml make(const YamlText & text, Yaml::Kind kind)
{
  Yaml node;
  node.kind = kind;
  node.line = text.line();
  return node;
}

void refuse_alias(const YamlText & text)
{
  if (text.look() == '*') {
    throw exceptions::RCLError("Will not support aliasing at line " + std::to_string(text.line()));
  }
}

/// Read the value after a dash or a colon: on the same line, or on the following lines.
Yaml item(YamlText & text, std::size_t least, bool may_nest)
{
  text.skip_blanks();
  const bool here = !text.is_at_end_of_line() && !text.is_over() && text.column() >= least;
  return here ? value(text, least, may_nest) : block(text, least);
}

Yaml list(YamlText & text, std::size_t column)
{
  Yaml node = make(text, Yaml::kList);
  while (!text.is_over() && text.column() == column && text.looks_at_dash()) {
    text.skip();
    node.parts.push_back(item(text, column + 1, true));
    text.seek();
  }
  if (!text.is_over() && text.column() > column) {text.fail();}
  return node;
}

Yaml map(YamlText & text, std::size_t column)
{
  Yaml node = make(text, Yaml::kMap);
  while (!text.is_over() && text.column() == column) {
    if (!text.looks_at_key()) {text.fail();}
    const std::string key = text.looks_at_one_of("\"'") ? text.quoted() : text.plain("");
    text.skip_blanks();
    text.skip();  // the colon
    text.skip_blanks();
    const unsigned line = text.line();
    const bool ends = text.is_at_end_of_line();
    if (ends) {text.seek();}
    // A list may have the same indentation as its key.
    const bool below =
      ends && !text.is_over() && text.column() == column && text.looks_at_dash();
    Yaml part = below ? list(text, column) : item(text, column + 1, ends);
    if (part.kind == Yaml::kEmpty) {part.line = line;}
    part.key = key;
    node.parts.push_back(std::move(part));
    text.seek();
  }
  if (!text.is_over() && text.column() > column) {text.fail();}
  return node;
}

/// Read a plain scalar, which continues on indented lines.
Yaml plain(YamlText & text, std::size_t least)
{
  if (text.looks_at_one_of("@`%,]}")) {text.fail();}
  Yaml node = make(text, Yaml::kScalar);
  while (true) {
    node.text += text.plain("");
    if (text.look() == ':') {text.fail();}
    const unsigned line = text.line();
    text.seek();
    if (text.is_over() || text.column() < least) {return node;}
    node.text += YamlText::fold(text.line() - line);
  }
}

/// Read a value in flow style: `[a, b]`, `{a: b}`, `"text"` or a plain scalar, on any number of lines.
Yaml flow(YamlText & text)
{
  refuse_alias(text);
  const char first = text.look();
  if (first != '[' && first != '{') {
    Yaml node = make(text, Yaml::kScalar);
    node.quoted = first == '"' || first == '\'';
    node.text = node.quoted ? text.quoted() : text.plain(",[]{}");
    if (node.text.empty() && !node.quoted) {text.fail();}
    return node;
  }
  const bool is_map = first == '{';
  const char last = is_map ? '}' : ']';
  Yaml node = make(text, is_map ? Yaml::kMap : Yaml::kList);
  text.skip();
  for (text.seek(); text.look() != last; text.seek()) {
    Yaml part = flow(text);
    text.seek();
    if (is_map) {
      const std::string key = part.text;
      if (part.kind != Yaml::kScalar || text.look() != ':') {text.fail();}
      text.skip();
      text.seek();
      part = text.looks_at_one_of(",}") ? make(text, Yaml::kEmpty) : flow(text);
      part.key = key;
      text.seek();
    }
    node.parts.push_back(std::move(part));
    if (text.look() == ',') {
      text.skip();
    } else if (text.look() != last) {
      text.fail();
    }
  }
  text.skip();
  return node;
}

/// Read a value; if `may_nest`, a block list or map may begin here, as it may not after a key.
Yaml value(YamlText & text, std::size_t least, bool may_nest)
{
  bool is_text = false;
  while (text.looks_at_one_of("!&")) {
    is_text = text.word() == "!!str" || is_text;
    text.skip_blanks();
  }
  refuse_alias(text);
  Yaml node;
  if (text.is_at_end_of_line()) {
    node = block(text, least);
  } else if (text.looks_at_one_of("|>")) {
    node = make(text, Yaml::kScalar);
    node.quoted = true;
    node.text = text.block(least);
  } else if (text.looks_at_dash()) {
    if (!may_nest) {text.fail();}
    node = list(text, text.column());
  } else if (may_nest && !text.looks_at_one_of("[{") && text.looks_at_key()) {
    node = map(text, text.column());
  } else if (text.looks_at_one_of("[{\"'")) {
    node = flow(text);
    text.finish();
  } else {
    node = plain(text, least);
  }
  node.quoted = node.quoted || is_text;
  return node;
}

/// Read a block that starts on a line of its own, in column `least` or further right.
Yaml block(YamlText & text, std::size_t least)
{
  const Yaml empty = make(text, Yaml::kEmpty);
  text.seek();
  return text.is_over() || text.column() < least ? empty : value(text, least, true);
}

}  // namespace

Yaml read_yaml(const std::string & file)
{
  YamlText text(file);
  for (text.seek(); text.look() == '%'; text.seek()) {text.skip_line();}
  if (text.looks_at_marker("---")) {text.skip(3);}
  Yaml root = block(text, 0);
  text.seek();
  if (!text.is_over() || text.looks_at_marker("---")) {text.fail();}
  return root;
}

}  // namespace detail
}  // namespace rclcpp
