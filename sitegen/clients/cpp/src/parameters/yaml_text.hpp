// The text of a YAML file: where a reader is in it, and what scalars stand for.
#pragma once

#include <cstddef>
#include <string>

namespace rclcpp
{
namespace detail
{

/// Goes over a text once, from left to right. A column is how far something is indented.
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
  /// Whether a key and its colon begin here.
  bool looks_at_key() const;
  /// `---` or `...`, on a line of its own.
  bool looks_at_marker(const char * marker) const;
  /// The document ends here.
  bool is_over() const;
  bool is_at_end_of_line() const {return looks_at_one_of("\n#") || look() == '\0';}
  std::size_t column() const {return at_ - start_;}
  unsigned line() const {return line_;}
  /// Throws exceptions::RCLError.
  [[noreturn]] void fail() const;

  void skip(std::size_t characters = 1) {at_ += characters;}
  void skip_blanks();
  void skip_line();
  /// Go to the next character that means something, on whatever line.
  void seek();
  /// Nothing more may stand on the line.
  void finish();

  /// What stands before the next space.
  std::string word();
  /// The rest of the line without blanks around it, up to a comment, a colon or one of `ends`.
  std::string plain(const char * ends);
  /// Text in quotes of either kind.
  std::string quoted();
  /// `|`, which keeps its lines, or `>`, which folds them; they stand at `least` or further right.
  std::string block(std::size_t least);
  /// What two texts are joined with that are so many lines apart.
  static std::string fold(unsigned lines);

private:
  bool done() const {return at_ >= text_.size();}
  void new_line();
  /// Go to the next line with anything on it; how many lines further it is.
  unsigned skip_lines();
  /// What the character after a backslash stands for.
  std::string escaped();

  std::string text_;
  std::size_t at_ = 0;
  std::size_t start_ = 0;  // of the line
  unsigned line_ = 1;
};

}  // namespace detail
}  // namespace rclcpp
