// The text of a YAML file: the read position and the values of scalars.
#pragma once

#include <cstddef>
#include <string>

namespace rclcpp
{
namespace detail
{

/// Reads a text once, from start to end. A column is an indentation.
class YamlText
{
public:
  explicit YamlText(const std::string & text);

  char look(std::size_t ahead = 0) const
  {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  bool looks_at_one_of(const char * these, std::size_t ahead = 0) const;
  bool looks_at_space(std::size_t ahead = 0) const;
  bool looks_at_dash() const {return look() == '-' && looks_at_space(1);}
  /// Whether there is a key with a colon at the read position.
  bool looks_at_key() const;
  /// Whether there is a document marker, `---` or `...`, on a line of its own.
  bool looks_at_marker(const char * marker) const;
  /// End the document here.
  bool is_over() const;
  bool is_at_end_of_line() const {return looks_at_one_of("\n#") || look() == '\0';}
  std::size_t column() const {return at_ - start_;}
  unsigned line() const {return line_;}
  /// Throws exceptions::RCLError.
  [[noreturn]] void fail() const;

  void skip(std::size_t characters = 1) {at_ += characters;}
  void skip_blanks();
  void skip_line();
  /// Skip blanks, line breaks and comments.
  void seek();
  /// Require the end of the line.
  void finish();

  /// Read up to the next space.
  std::string word();
  /// Read the rest of the line, trimmed, up to a comment, a colon or one of `ends`.
  std::string plain(const char * ends);
  /// Read a string in single or double quotes.
  std::string quoted();
  /// Read a block scalar, `|` (literal) or `>` (folded), in column `least` or further right.
  std::string block(std::size_t least);
  /// The separator of two folded lines with a number of line breaks between them.
  static std::string fold(unsigned lines);

private:
  bool done() const {return at_ >= text_.size();}
  void new_line();
  /// Skip to the next line that is not empty; return the number of line breaks.
  unsigned skip_lines();
  /// Read the character of an escape sequence.
  std::string escaped();

  std::string text_;
  std::size_t at_ = 0;
  std::size_t start_ = 0;  // start of the line
  unsigned line_ = 1;
};

}  // namespace detail
}  // namespace rclcpp
