#pragma once

#include <chrono>
#include <stdexcept>

namespace rcpputils
{

/// Throws std::invalid_argument if `time` does not fit.
template<class Rep, class Period>
std::chrono::nanoseconds convert_to_nanoseconds(const std::chrono::duration<Rep, Period> & time)
{
  using Nanoseconds = std::chrono::duration<double, std::nano>;
  if (time > Nanoseconds(std::chrono::nanoseconds::max())) {
    throw std::invalid_argument("time must be less than std::chrono::nanoseconds::max()");
  }
  if (time < Nanoseconds(std::chrono::nanoseconds::min())) {
    throw std::invalid_argument("time must be bigger than std::chrono::nanoseconds::min()");
  }
  return std::chrono::duration_cast<std::chrono::nanoseconds>(time);
}

}  // namespace rcpputils
