#pragma once

#include <string>
#include <utility>

namespace rclcpp
{

/// A named logger; level and name are looked up by its dotted parents, as in rcutils.
class Logger
{
public:
  enum class Level {Unset = 0, Debug = 10, Info = 20, Warn = 30, Error = 40, Fatal = 50};

  explicit Logger(std::string name)
  : name_(std::move(name)) {}

  const char * get_name() const {return name_.c_str();}
  Logger get_child(const std::string & suffix) const
  {
    return Logger(name_.empty() ? suffix : name_ + "." + suffix);
  }
  void set_level(Level level);
  Level get_effective_level() const;

private:
  std::string name_;
};

inline Logger get_logger(const std::string & name) {return Logger(name);}

}  // namespace rclcpp
