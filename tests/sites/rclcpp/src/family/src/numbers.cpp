// Floating-point numbers as text and from text, by <charconv>.
#include <charconv>
#include <cinttypes>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <string>
#include <system_error>

#include "rclcpp/rclcpp.hpp"

using std::chars_format;

static_assert(__cpp_lib_to_chars >= 201611L);

constexpr chars_format kFormats[] = {
  chars_format::general, chars_format::scientific, chars_format::fixed, chars_format::hex};

std::uint64_t bits(double value)
{
  std::uint64_t all;
  std::memcpy(&all, &value, sizeof all);
  return all;
}

template<class... Args>
std::string text(Args... arguments)
{
  static char buffer[2000];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, arguments...);
  return error == std::errc() ? std::string(buffer, end) : "?";
}

void write(double value)
{
  std::printf("double %016" PRIx64 " %s", bits(value), text(value).c_str());
  for (const auto format : kFormats) {std::printf(" %s", text(value, format).c_str());}
  for (const auto format : kFormats) {std::printf(" %s", text(value, format, 3).c_str());}
  std::puts("");
}

template<class T>
void read(const std::string & from, chars_format format)
{
  T value = 77;
  const char * const end = from.data() + from.size();
  const auto [at, error] = std::from_chars(from.data(), end, value, format);
  const char * what = error == std::errc() ? "" :
    error == std::errc::invalid_argument ? " invalid" :
    error == std::errc::result_out_of_range ? " range" : " ?";
  std::printf(
    "read %d [%s] %016" PRIx64 " %d%s\n", static_cast<int>(format), from.c_str(),
    bits(static_cast<double>(value)), static_cast<int>(at - from.data()), what);
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  std::uint64_t random = 88172645463325252u;
  for (int i = 0; i < 240; ++i) {
    random ^= random << 13;
    random ^= random >> 7;
    random ^= random << 17;
    double any;
    // Of all sizes, and every eighth one subnormal.
    const std::uint64_t some = i % 8 ? random : random & 0x800fffffffffffff >> i % 48;
    std::memcpy(&any, &some, sizeof any);
    write(any);
    write(static_cast<double>(random % 2000000) / 1000 - 1000);
    write(std::ldexp(1, i * 8 - 1074));
  }
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {0.0, -0.0, 1e22, 1e23, 1e5, 1e-5, 123456.0, 1234567.0, infinity, -infinity}) {
    write(value);
  }
  for (const char * from : {
      "1.5", "-1.5", "+1.5", " 1.5", "1.", "1.e5", ".5", ".", "-", "", "-.5e1x", "1e", "1e+", "1E5", "1e+5",
      "1e++5", "1e400", "-1e400", "1e-400", "1e-323", "0e999", "0x1p3", "1p3", "1.8p1", "1.8P+1", "ap", "A.8p-1",
      "p1", "inf", "-INF", "infinity", "infin", "-inf5", "nan", "NaN(a_1)", "nan(a b)", "nan(", "nan()", "e5",
      "1e5.5", "00012", "1_0", "1,5", "--1", "-0", "-0.0", "1.0.0", "2.4703282292062327e-324",
      "2.4703282292062328e-324", "1.7976931348623158e308", "1.7976931348623159e308", "1e99999999999999999999",
      "1e-99999999999999999999", "0.000000000000000000000000000000000000001e340", "1ffffffffffffffff",
      "9007199254740993", "9007199254740993.0000000000000000000000000000000000000000000000000000000000000000001",
      "1p-1075", "1.0000000000000001p-1075", "1p1024", "1.fffffffffffff8p1023", "1p99999999999",
      "1.00000000000008p0", "1.00000000000018p0", "8f986e0d9c95f7ef.5f15567d93acc7c0p-1107"})
  {
    for (const auto format : kFormats) {read<double>(from, format);}
  }
  for (const char * from : {
      "0.1", "16777217", "3.4028235e38", "3.4028236e38", "1e-45", "7e-46", "1.00000017881393432617187499",
      "1.00000017881393432617187500", "1.00000017881393432617187501"})
  {
    read<float>(from, chars_format::general);
  }
  read<long double>("1e-2x", chars_format::general);
  std::printf("float %s", text(0.1F).c_str());
  for (const float value : {1e10F, 3.4028235e38F, 1e-45F, std::ldexp(1.0F, -30)}) {
    std::printf(" %s %s", text(value).c_str(), text(value, chars_format::hex).c_str());
  }
  std::printf(" %s %s\n", text(16777216.0F, chars_format::fixed).c_str(), text(0.5L).c_str());
  char little[4];
  const auto result = std::to_chars(little, little + sizeof little, -1.25);
  std::printf(
    "little %d %d", result.ptr == little + sizeof little, result.ec == std::errc::value_too_large);
  int whole = 0;
  const char number[] = "42";
  std::printf(" %d", std::from_chars(number, number + 2, whole).ec == std::errc());
  std::printf(" %d %s\n", whole, text(whole).c_str());
  rclcpp::shutdown();
}
