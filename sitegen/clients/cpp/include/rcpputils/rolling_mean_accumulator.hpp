#pragma once

#include <cstddef>
#include <vector>

namespace rcpputils
{

/// The mean of the last numbers in a window.
template<typename T>
class RollingMeanAccumulator
{
public:
  explicit RollingMeanAccumulator(std::size_t rolling_window_size)
  : window_(rolling_window_size) {}

  void accumulate(T number)
  {
    sum_ += number - window_[next_];
    window_[next_] = number;
    next_ = (next_ + 1) % window_.size();
    if (count_ < window_.size()) {++count_;}
  }
  T getRollingMean() const {return sum_ / static_cast<T>(count_);}

private:
  std::vector<T> window_;
  std::size_t next_ = 0;
  std::size_t count_ = 0;
  T sum_ = 0;
};

}  // namespace rcpputils
