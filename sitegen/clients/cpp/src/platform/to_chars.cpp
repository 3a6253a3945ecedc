// Floating-point numbers as text; see include/charconv.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>

#if _LIBCPP_VERSION < 14000

namespace
{

using std::chars_format;

/// `digits` without zeros at the end; the first one counts 10 to the power of `exponent`.
struct Decimal
{
  std::string digits;
  int exponent;
};

std::string print(const char * format, int precision, double value)
{
  std::string text(std::snprintf(nullptr, 0, format, precision, value), '\0');
  std::snprintf(text.data(), text.size() + 1, format, precision, value);
  return text;
}

float read(const char * text, float) {return std::strtof(text, nullptr);}
double read(const char * text, double) {return std::strtod(text, nullptr);}

/// Make the mantissa of `text` larger by one in its last digit.
void increment(std::string & text)
{
  for (auto at = text.find('e'); at-- > 0; ) {
    if (text[at] == '.') {continue;}
    if (text[at] != '9') {
      ++text[at];
      return;
    }
    text[at] = '0';
  }
}

/// The fewest digits that are read as `value`, and of those the nearest ones.
template<class T>
Decimal shortest(T value)
{
  using Limits = std::numeric_limits<T>;
  // Numbers of digits10 digits survive: a shorter text is this one without its zeros. That is not
  // so for subnormal numbers.
  int count = value < Limits::min() ? 1 : Limits::digits10;
  std::string text;
  for (;; ++count) {
    text = print("%.*e", count - 1, value);
    if (count == Limits::max_digits10 || read(text.c_str(), value) == value) {break;}
    // The numbers below a power of two are nearer to it than those above. If the nearest text is
    // below and too far, one above may be near enough.
    increment(text);
    if (read(text.c_str(), value) == value) {break;}
  }
  const auto e = text.find('e');
  const int exponent = std::atoi(text.c_str() + e + 1);
  text.resize(e);
  text.erase(std::remove(text.begin(), text.end(), '.'), text.end());
  text.resize(std::max<std::size_t>(text.find_last_not_of('0') + 1, 1));
  return {text, exponent};
}

std::string scientific(const Decimal & decimal)
{
  std::string text = decimal.digits;
  if (text.size() > 1) {text.insert(1, ".");}
  char exponent[8];
  std::snprintf(exponent, sizeof exponent, "e%+03d", decimal.exponent);
  return text + exponent;
}

std::string fixed(const Decimal & decimal, double value)
{
  std::string text = decimal.digits;
  const int exponent = decimal.exponent;
  if (exponent < 0) {return "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + text;}
  const auto whole = static_cast<std::size_t>(exponent) + 1;
  // A whole number is exact.
  return text.size() <= whole ? print("%.*f", 0, value) : text.insert(whole, ".");
}

/// As glibc, which does not normalize subnormal numbers.
template<class T>
std::string hexadecimal(T value, int precision)
{
  using Limits = std::numeric_limits<T>;
  constexpr int kDigits = (Limits::digits + 2) / 4;
  const int exponent = value == 0 ? 0 : std::max(std::ilogb(value), Limits::min_exponent - 1);
  auto mantissa = static_cast<std::uint64_t>(std::ldexp(value, 4 * kDigits - exponent));
  if (precision >= 0 && precision < kDigits) {
    const int dropped = 4 * (kDigits - precision);
    const std::uint64_t half = std::uint64_t(1) << (dropped - 1);
    mantissa += half - 1 + (mantissa >> dropped & 1);  // to even
    mantissa = mantissa >> dropped << dropped;
  }
  std::string text(1, static_cast<char>('0' + (mantissa >> 4 * kDigits)));
  text += '.';
  for (int at = kDigits - 1; at >= 0; --at) {text += "0123456789abcdef"[mantissa >> 4 * at & 15];}
  if (precision < 0) {
    text.resize(text.find_last_not_of('0') + 1);
  } else {
    text.resize(static_cast<std::size_t>(precision) + 2, '0');
  }
  if (text.back() == '.') {text.pop_back();}
  char power[8];
  std::snprintf(power, sizeof power, "p%+d", exponent);
  return text + power;
}

template<class T>
std::string shortest_text(T value, chars_format format)
{
  if (format == chars_format::hex) {return hexadecimal(value, -1);}
  const Decimal decimal = value == 0 ? Decimal{"0", 0} : shortest(value);
  const bool moderate = decimal.exponent >= -4 && decimal.exponent < 6;
  if (format == chars_format::fixed || (format == chars_format::general && moderate)) {
    return fixed(decimal, value);
  }
  const std::string text = scientific(decimal);
  if (format == chars_format::scientific || format == chars_format::general) {return text;}
  // Without a format, the shorter one.
  const std::string other = fixed(decimal, value);
  return other.size() <= text.size() ? other : text;
}

template<class T>
std::string precise_text(T value, chars_format format, int precision)
{
  switch (format) {
    case chars_format::hex: return hexadecimal(value, precision);
    case chars_format::fixed: return print("%.*f", precision, value);
    case chars_format::scientific: return print("%.*e", precision, value);
    default: return print("%.*g", precision, value);
  }
}

/// Write a number; `text` makes the text of its absolute value.
template<class T, class TextT>
std::to_chars_result write(char * first, char * last, T value, TextT text)
{
  std::string all = std::signbit(value) ? "-" : "";
  all += std::isnan(value) ? "nan" : std::isinf(value) ? "inf" : text(std::fabs(value));
  if (static_cast<std::size_t>(last - first) < all.size()) {
    return {last, std::errc::value_too_large};
  }
  return {std::copy(all.begin(), all.end(), first), std::errc()};
}

template<class T>
std::to_chars_result write(char * first, char * last, T value, chars_format format)
{
  return write(first, last, value, [&](T size) {return shortest_text(size, format);});
}

template<class T>
std::to_chars_result write(
  char * first, char * last, T value, chars_format format, int precision)
{
  return write(first, last, value, [&](T size) {return precise_text(size, format, precision);});
}

}  // namespace

namespace std
{

to_chars_result to_chars(char * first, char * last, float value)
{
  return write(first, last, value, chars_format());
}
to_chars_result to_chars(char * first, char * last, float value, chars_format format)
{
  return write(first, last, value, format);
}
to_chars_result to_chars(
  char * first, char * last, float value, chars_format format, int precision)
{
  return write(first, last, value, format, precision);
}

to_chars_result to_chars(char * first, char * last, double value)
{
  return write(first, last, value, chars_format());
}
to_chars_result to_chars(char * first, char * last, double value, chars_format format)
{
  return write(first, last, value, format);
}
to_chars_result to_chars(
  char * first, char * last, double value, chars_format format, int precision)
{
  return write(first, last, value, format, precision);
}

to_chars_result to_chars(char * first, char * last, long double value)
{
  return to_chars(first, last, static_cast<double>(value));
}
to_chars_result to_chars(char * first, char * last, long double value, chars_format format)
{
  return to_chars(first, last, static_cast<double>(value), format);
}
to_chars_result to_chars(
  char * first, char * last, long double value, chars_format format, int precision)
{
  return to_chars(first, last, static_cast<double>(value), format, precision);
}

}  // namespace std

#endif
