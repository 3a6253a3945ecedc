// Serialize and deserialize messages: CDR (XCDR1, little-endian) with a header of four bytes, as in
// native ROS 2.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "rosidl_runtime_cpp/bounded_vector.hpp"

namespace rosidl_typesupport_sitegen_cpp
{

/// Visits the fields of a message and measures, writes or reads each. It is one class for all
/// three, so that a message needs only one function.
class Cdr
{
public:
  /// Measure: size() is then the number of bytes to write.
  Cdr() = default;
  /// Write to `out`, which has at least the measured size.
  static Cdr writer(std::uint8_t * out);
  /// Read `size` bytes from `in`; ok() returns whether they were valid.
  static Cdr reader(const std::uint8_t * in, std::size_t size);

  std::size_t size() const {return position_ + kHeader;}
  bool ok() const {return ok_;}

  void operator()(bool & value);
  void operator()(std::string & value);
  void operator()(std::u16string & value);

  template<class T>
  void operator()(T & value)
  {
    if constexpr (std::is_same_v<T, char16_t>) {
      wide(value);
    } else if constexpr (std::is_arithmetic_v<T>) {
      block(&value, sizeof(T), 1);
    } else {
      visit_fields(*this, value);  // generated for each message, found by its namespace
    }
  }

  template<class T, std::size_t N>
  void operator()(std::array<T, N> & values) {elements(values, N);}

  template<class T, class A>
  void operator()(std::vector<T, A> & values) {sequence(values, SIZE_MAX);}

  template<class T, std::size_t N, class A>
  void operator()(rosidl_runtime_cpp::BoundedVector<T, N, A> & values) {sequence(values, N);}

  /// A bounded string; reading a longer one fails.
  template<class String>
  void bounded(String & value, std::size_t bound)
  {
    if (mode_ != Mode::kRead && value.size() > bound) {too_long(value.size(), bound);}
    (*this)(value);
    ok_ = ok_ && value.size() <= bound;
  }

private:
  friend struct CVisitor;  // messages as C structs

  enum class Mode {kMeasure, kWrite, kRead};
  static constexpr std::size_t kHeader = 4;

  template<class T>
  static constexpr bool is_block =
    std::is_arithmetic_v<T> && !std::is_same_v<T, bool> && !std::is_same_v<T, char16_t>;

  template<class Sequence>
  void sequence(Sequence & values, std::size_t bound)
  {
    using T = typename Sequence::value_type;
    const std::size_t count = length(values.size());
    if (mode_ != Mode::kRead) {
      elements(values, count);
      return;
    }
    // The length may be wrong: allocate only for as many elements as there are bytes.
    ok_ = ok_ && count <= bound;
    if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, char16_t>) {
      ok_ = ok_ && count <= left() / sizeof(T);
      if (!ok_) {return;}
      values.resize(count);
      elements(values, count);
    } else {
      values.clear();
      values.reserve(std::min(ok_ ? count : 0, left() / sizeof(T) + 1));
      for (std::size_t i = 0; i < count && ok_; ++i) {
        values.emplace_back();
        (*this)(values.back());
      }
    }
  }

  template<class Sequence>
  void elements(Sequence & values, std::size_t count)
  {
    using T = typename Sequence::value_type;
    if constexpr (is_block<T>) {
      if (count) {block(&values[0], sizeof(T), count);}
    } else if constexpr (std::is_same_v<T, bool>) {
      for (std::size_t i = 0; i < count; ++i) {  // std::vector<bool> has no bool & to pass on
        bool value = values[i];
        (*this)(value);
        values[i] = value;
      }
    } else {
      for (std::size_t i = 0; i < count && ok_; ++i) {(*this)(values[i]);}
    }
  }

  [[noreturn]] static void too_long(std::size_t size, std::size_t bound);
  void wide(char16_t & value);
  std::size_t length(std::size_t count);
  std::size_t left() const {return position_ < end_ ? end_ - position_ : 0;}
  void align(std::size_t size);
  bool room(std::size_t size);
  void block(void * data, std::size_t size, std::size_t count);
  void bytes(void * data, std::size_t size);

  Mode mode_ = Mode::kMeasure;
  bool ok_ = true;
  std::uint8_t * out_ = nullptr;
  const std::uint8_t * in_ = nullptr;
  std::size_t end_ = 0;
  std::size_t position_ = 0;
};

}  // namespace rosidl_typesupport_sitegen_cpp
