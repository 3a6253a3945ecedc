#include "robot_model/xml.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>

namespace robot_model
{
namespace
{

class Reader
{
public:
  explicit Reader(const std::string & text)
  : text_(text) {}

  Element document()
  {
    skip_to_element();
    Element root = element();
    skip_to_element();
    if (at_ < text_.size()) {fail("there is something behind the root element");}
    return root;
  }

private:
  [[noreturn]] void fail(const std::string & message) const
  {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + std::min(at_, text_.size()), '\n');
    throw std::runtime_error("line " + std::to_string(line) + ": " + message);
  }
  bool is(const char * what) const {return text_.compare(at_, std::string(what).size(), what) == 0;}
  void skip_behind(const char * what)
  {
    const auto found = text_.find(what, at_);
    if (found == std::string::npos) {fail(std::string("'") + what + "' is missing");}
    at_ = found + std::string(what).size();
  }
  void skip_space()
  {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) {++at_;}
  }

  /// Skip text, comments and everything else that is not an element.
  void skip_to_element()
  {
    for (;; ) {
      at_ = std::min(text_.find('<', at_), text_.size());
      if (is("<!--")) {
        skip_behind("-->");
      } else if (is("<![CDATA[")) {
        skip_behind("]]>");
      } else if (is("<?")) {
        skip_behind("?>");
      } else if (is("<!")) {
        skip_behind(">");
      } else {
        return;
      }
    }
  }

  std::string name()
  {
    const auto begin = at_;
    at_ = std::min(text_.find_first_of(" \t\r\n=/>", at_), text_.size());
    if (at_ == begin) {fail("a name is missing");}
    return text_.substr(begin, at_ - begin);
  }

  Element element()
  {
    if (!is("<")) {fail("there is no element");}
    ++at_;
    Element found;
    found.name = name();
    for (;; ) {
      skip_space();
      if (is("/>")) {
        at_ += 2;
        return found;
      }
      if (is(">")) {
        ++at_;
        break;
      }
      std::string key = name();
      found.attributes[key] = value();
    }
    for (;; ) {
      skip_to_element();
      if (is("</")) {
        at_ += 2;
        if (name() != found.name) {fail("<" + found.name + "> is not closed here");}
        skip_behind(">");
        return found;
      }
      if (at_ >= text_.size()) {fail("<" + found.name + "> is not closed");}
      found.children.push_back(element());
    }
  }

  std::string value()
  {
    skip_space();
    if (!is("=")) {fail("an attribute has no value");}
    ++at_;
    skip_space();
    const char quote = at_ < text_.size() ? text_[at_] : 0;
    const auto end = quote == '"' || quote == '\'' ? text_.find(quote, at_ + 1) : std::string::npos;
    if (end == std::string::npos) {fail("an attribute has no value between quotes");}
    const std::string raw = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    return resolved(raw);
  }

  static std::string resolved(const std::string & raw)
  {
    static const std::map<std::string, char> known{
      {"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}};
    std::string text;
    for (std::size_t i = 0; i < raw.size(); ++i) {
      const auto end = raw[i] == '&' ? raw.find(';', i) : std::string::npos;
      const auto found = end == std::string::npos ? known.end() : known.find(raw.substr(i + 1, end - i - 1));
      if (found == known.end()) {
        text += raw[i];
      } else {
        text += found->second;
        i = end;
      }
    }
    return text;
  }

  const std::string & text_;
  std::size_t at_ = 0;
};

}  // namespace

const Element * Element::child(const std::string & wanted) const
{
  for (const Element & each : children) {
    if (each.name == wanted) {return &each;}
  }
  return nullptr;
}

std::string Element::attribute(const std::string & wanted, const std::string & fallback) const
{
  const auto found = attributes.find(wanted);
  return found == attributes.end() ? fallback : found->second;
}

Element parse_xml(const std::string & text) {return Reader(text).document();}

}  // namespace robot_model
