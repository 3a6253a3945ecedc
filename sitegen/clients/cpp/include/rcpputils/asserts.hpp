#pragma once

#include <stdexcept>
#include <string>

namespace rcpputils
{

class IllegalStateException : public std::runtime_error
{
public:
  explicit IllegalStateException(const char * message)
  : std::runtime_error(message) {}
};

class AssertionException : public std::runtime_error
{
public:
  explicit AssertionException(const char * message)
  : std::runtime_error(message) {}
};

inline void require_true(
  bool condition, const std::string & message = "invalid argument passed in")
{
  if (!condition) {throw std::invalid_argument{message};}
}

/// Without effect if NDEBUG is defined.
inline void assert_true(bool condition, const std::string & message = "assertion failed")
{
#ifdef NDEBUG
  static_cast<void>(condition);
  static_cast<void>(message);
#else
  if (!condition) {throw AssertionException{message.c_str()};}
#endif
}

inline void check_true(bool condition, const std::string & message = "check reported invalid state")
{
  if (!condition) {throw IllegalStateException{message.c_str()};}
}

}  // namespace rcpputils
