// Floating-point numbers from text; see include/charconv.
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <type_traits>

namespace
{

/// Where `word` ends at `at`, in upper or lower case; null if it is not there.
const char * after_word(const char * at, const char * last, const char * word)
{
  for (; *word; ++at, ++word) {
    if (at == last || (*at | 0x20) != *word) {return nullptr;}
  }
  return at;
}

const char * after_digits(const char * at, const char * last, bool hex)
{
  for (; at != last; ++at) {
    const char letter = *at | 0x20;
    if (!(*at >= '0' && *at <= '9') && !(hex && letter >= 'a' && letter <= 'f')) {break;}
  }
  return at;
}

/// Where "nan" ends, with what may follow in brackets.
const char * after_nan(const char * at, const char * last)
{
  const char * end = after_word(at, last, "nan");
  if (!end || end == last || *end != '(') {return end;}
  const char * close = end + 1;
  while (close != last && (std::isalnum(static_cast<unsigned char>(*close)) || *close == '_')) {
    ++close;
  }
  return close != last && *close == ')' ? close + 1 : end;
}

/// Where the digits and the point end; null without a digit.
const char * after_mantissa(const char * at, const char * last, bool hex)
{
  const char * whole = after_digits(at, last, hex);
  if (whole == last || *whole != '.') {return whole == at ? nullptr : whole;}
  const char * end = after_digits(whole + 1, last, hex);
  return end - at == 1 ? nullptr : end;
}

/// Where the exponent ends; `at` without one.
const char * after_exponent(const char * at, const char * last, char letter)
{
  if (at == last || (*at | 0x20) != letter) {return at;}
  const char * digits = at + 1;
  if (digits != last && (*digits == '+' || *digits == '-')) {++digits;}
  const char * end = after_digits(digits, last, false);
  return end == digits ? at : end;
}

bool is_zero(const char * at, const char * end)
{
  while (at != end && (*at == '0' || *at == '.')) {++at;}
  return at == end;
}

// Those of this C library round correctly, and know no locale.
void convert(const char * text, float & value) {value = std::strtof(text, nullptr);}
void convert(const char * text, double & value) {value = std::strtod(text, nullptr);}
void convert(const char * text, long double & value) {value = std::strtold(text, nullptr);}

/// The C library rounds a subnormal number with many digits wrongly.
template<class T>
T read_hexadecimal(const char * begin, const char * mantissa, const char * end)
{
  constexpr int kDigits = 15;  // in 64 bits, with more to round by than a double has
  std::uint64_t bits = 0;
  std::int64_t exponent = 0;
  int count = 0;
  bool fraction = false, more = false;
  for (const char * at = begin; at != mantissa; ++at) {
    if (*at == '.') {
      fraction = true;
      continue;
    }
    const int digit = *at <= '9' ? *at - '0' : (*at | 0x20) - 'a' + 10;
    const bool fits = count < kDigits;
    if (fits) {bits = bits * 16 + static_cast<unsigned>(digit);}
    if (bits) {++count;}
    more = more || (!fits && digit);
    exponent += fits ? (fraction ? -4 : 0) : (fraction ? 0 : 4);
  }
  if (end != mantissa) {
    const std::int64_t far = 1 << 30;
    exponent += std::clamp<std::int64_t>(std::strtoll(mantissa + 1, nullptr, 10), -far, far);
  }
  if (!bits) {return 0;}
  using Limits = std::numeric_limits<T>;
  const std::int64_t dropped = std::max<std::int64_t>(
    64 - __builtin_clzll(bits) - Limits::digits, Limits::min_exponent - Limits::digits - exponent);
  if (dropped > 62) {return 0;}
  if (dropped > 0) {
    bits = (bits | more) + (std::uint64_t(1) << (dropped - 1)) - 1 + (bits >> dropped & 1);  // to even
    bits >>= dropped;
    exponent += dropped;
  }
  return std::scalbln(static_cast<T>(bits), static_cast<long>(exponent));
}

template<class T>
std::from_chars_result read(
  const char * first, const char * last, T & value, std::chars_format format)
{
  const bool negative = first != last && *first == '-';
  const char * const begin = negative ? first + 1 : first;
  const auto accept = [&](T found, const char * end) -> std::from_chars_result {
      value = negative ? -found : found;
      return {end, std::errc()};
    };
  if (const char * end = after_word(begin, last, "inf")) {
    const char * whole = after_word(end, last, "inity");
    return accept(std::numeric_limits<T>::infinity(), whole ? whole : end);
  }
  if (const char * end = after_nan(begin, last)) {
    return accept(std::numeric_limits<T>::quiet_NaN(), end);
  }
  const bool hex = format == std::chars_format::hex;
  const char * const mantissa = after_mantissa(begin, last, hex);
  if (!mantissa) {return {first, std::errc::invalid_argument};}
  const bool fixed = format == std::chars_format::fixed;
  const char * const end = fixed ? mantissa : after_exponent(mantissa, last, hex ? 'p' : 'e');
  if (format == std::chars_format::scientific && end == mantissa) {
    return {first, std::errc::invalid_argument};
  }
  // A copy, because more may follow.
  const std::string text(begin, end);
  T found;
  if (hex && !std::is_same_v<T, long double>) {
    const char * const at = text.data();
    found = read_hexadecimal<T>(at, at + (mantissa - begin), at + text.size());
  } else {
    convert(((hex ? "0x" : "") + text).c_str(), found);
  }
  if (std::isinf(found) || (found == 0 && !is_zero(begin, mantissa))) {
    return {end, std::errc::result_out_of_range};
  }
  return accept(found, end);
}

}  // namespace

namespace std
{

from_chars_result from_chars(
  const char * first, const char * last, float & value, chars_format format)
{
  return read(first, last, value, format);
}

from_chars_result from_chars(
  const char * first, const char * last, double & value, chars_format format)
{
  return read(first, last, value, format);
}

from_chars_result from_chars(
  const char * first, const char * last, long double & value, chars_format format)
{
  return read(first, last, value, format);
}

}  // namespace std
