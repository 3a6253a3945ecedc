#include "yaml_text.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iterator>

#include "rclcpp/exceptions.hpp"

namespace rclcpp
{
namespace detail
{

namespace
{

bool is_blank(char c) {return c == ' ' || c == '\t';}
bool is_end(char c) {return c == '\n' || c == '\0';}

std::string utf8(unsigned long code)
{
  if (code < 0x80) {return std::string(1, static_cast<char>(code));}
  int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  std::string bytes(1, static_cast<char>((0xFF00 >> (more + 1)) | (code >> 6 * more)));
  while (more--) {bytes += static_cast<char>(0x80 | (code >> 6 * more & 0x3F));}
  return bytes;
}

}  // namespace

YamlText::YamlText(const std::string & text)
{
  std::copy_if(
    text.begin(), text.end(), std::back_inserter(text_), [](char c) {return c != '\r';});
}

bool YamlText::looks_at_one_of(const char * these, std::size_t ahead) const
{
  const char c = look(ahead);
  return c && std::strchr(these, c);
}

bool YamlText::looks_at_space(std::size_t ahead) const
{
  return is_blank(look(ahead)) || is_end(look(ahead));
}

bool YamlText::looks_at_key() const
{
  std::size_t i = 0;
  const char quote = look();
  if (quote == '"' || quote == '\'') {
    for (++i; look(i) != quote || (quote == '\'' && look(i + 1) == quote); ++i) {
      if (is_end(look(i))) {return false;}
      if (look(i) == (quote == '"' ? '\\' : '\'')) {++i;}
    }
    for (++i; is_blank(look(i)); ++i) {}
    return look(i) == ':' && looks_at_space(i + 1);
  }
  for (; !is_end(look(i)); ++i) {
    if (look(i) == ':' && looks_at_space(i + 1)) {return i > 0;}
    if (look(i) == '#' && (i == 0 || is_blank(look(i - 1)))) {return false;}
  }
  return false;
}

bool YamlText::looks_at_marker(const char * marker) const
{
  return column() == 0 && text_.compare(at_, 3, marker) == 0 && looks_at_space(3);
}

bool YamlText::is_over() const
{
  return done() || looks_at_marker("---") || looks_at_marker("...");
}

void YamlText::fail() const
{
  throw exceptions::RCLError("Error parsing a event near line " + std::to_string(line_));
}

void YamlText::skip_blanks() {while (is_blank(look())) {++at_;}}

void YamlText::skip_line() {while (!is_end(look())) {++at_;}}

void YamlText::new_line()
{
  start_ = ++at_;
  ++line_;
}

void YamlText::seek()
{
  for (skip_blanks(); !done(); skip_blanks()) {
    if (look() == '#') {skip_line();}
    if (look() != '\n') {return;}
    new_line();
  }
}

void YamlText::finish()
{
  skip_blanks();
  if (!is_at_end_of_line()) {fail();}
}

std::string YamlText::word()
{
  const auto begin = at_;
  while (!looks_at_space()) {++at_;}
  return text_.substr(begin, at_ - begin);
}

std::string YamlText::plain(const char * ends)
{
  const auto begin = at_;
  for (; !is_end(look()) && !looks_at_one_of(ends); ++at_) {
    if (look() == '#' && at_ > begin && is_blank(text_[at_ - 1])) {break;}
    if (look() == ':' && (looks_at_space(1) || looks_at_one_of(ends, 1))) {break;}
  }
  auto end = at_;
  while (end > begin && is_blank(text_[end - 1])) {--end;}
  return text_.substr(begin, end - begin);
}

std::string YamlText::fold(unsigned lines)
{
  return lines == 1 ? " " : std::string(std::max(lines, 1u) - 1, '\n');
}

unsigned YamlText::skip_lines()
{
  const unsigned before = line_;
  while (look() == '\n') {
    new_line();
    skip_blanks();
  }
  return line_ - before;
}

std::string YamlText::quoted()
{
  std::string text;
  const char quote = look();
  std::size_t kept = 0;  // escaped blanks at the end of a line are not trimmed
  ++at_;
  while (look() != quote || (quote == '\'' && look(1) == quote)) {
    if (done()) {fail();}
    if (look() == '\n') {
      while (text.size() > kept && is_blank(text.back())) {text.pop_back();}
      text += fold(skip_lines());
    } else if (quote == '"' && look() == '\\') {
      ++at_;
      if (look() == '\n') {
        skip_lines();
      } else {
        text += escaped();
      }
      kept = text.size();
    } else {
      if (look() == quote) {++at_;}  // a doubled quote
      text += look();
      ++at_;
    }
  }
  ++at_;
  return text;
}

std::string YamlText::escaped()
{
  static const char kNames[] = "ntr0abefv";
  static const char kMeanings[] = "\n\t\r\0\a\b\x1b\f\v";
  const char c = look();
  ++at_;
  if (const char * name = c ? std::strchr(kNames, c) : nullptr) {
    return std::string(1, kMeanings[name - kNames]);
  }
  if (c == 'x' || c == 'u' || c == 'U') {
    const std::size_t size = c == 'x' ? 2 : c == 'u' ? 4 : 8;
    const std::string digits = text_.substr(at_, size);
    char * end;
    const unsigned long code = std::strtoul(digits.c_str(), &end, 16);
    if (digits.size() != size || *end) {fail();}
    at_ += size;
    return utf8(code);
  }
  if (!c || !std::strchr("\"\\/ ", c)) {fail();}
  return std::string(1, c);
}

std::string YamlText::block(std::size_t least)
{
  const bool folded = look() == '>';
  char chomp = 0;
  std::size_t indent = 0;
  for (++at_; !looks_at_space(); ++at_) {
    if (look() == '-' || look() == '+') {
      chomp = look();
    } else if (look() >= '1' && look() <= '9') {
      indent = least + static_cast<std::size_t>(look() - '1');
    } else {
      fail();
    }
  }
  finish();
  skip_line();
  std::string text;
  unsigned empty = 0;  // empty lines since the last one with text
  bool apart = true;   // the line break before this line is not folded
  while (!done()) {
    new_line();
    while (look() == ' ' && (indent == 0 || column() < indent)) {++at_;}
    if (is_end(look())) {
      empty += look() == '\n';
      continue;
    }
    if (column() < std::max(indent, least)) {
      at_ = start_;
      break;
    }
    if (indent == 0) {indent = column();}
    const unsigned lines = empty + !text.empty();
    apart = apart || is_blank(look());
    text += folded && !apart ? fold(lines) : std::string(lines, '\n');
    apart = is_blank(look());
    empty = 0;
    const auto begin = at_;
    skip_line();
    text.append(text_, begin, at_ - begin);
  }
  if (chomp == '+' || (chomp == 0 && !text.empty())) {text += '\n';}
  if (chomp == '+') {text.append(empty, '\n');}
  return text;
}

}  // namespace detail
}  // namespace rclcpp
