#pragma once

#include <string>
#include <utility>
#include <vector>

#include "rclcpp/context.hpp"
#include "rclcpp/contexts/default_context.hpp"

namespace rclcpp
{

class NodeOptions
{
public:
  NodeOptions() = default;

  Context::SharedPtr context() const {return context_;}
  NodeOptions & context(Context::SharedPtr context)
  {
    context_ = std::move(context);
    return *this;
  }
  /// Arguments of this node alone, with their `--ros-args`; they come before those of the program.
  const std::vector<std::string> & arguments() const {return arguments_;}
  NodeOptions & arguments(const std::vector<std::string> & arguments)
  {
    arguments_ = arguments;
    return *this;
  }
  bool use_global_arguments() const {return use_global_arguments_;}
  NodeOptions & use_global_arguments(bool use)
  {
    use_global_arguments_ = use;
    return *this;
  }

private:
  Context::SharedPtr context_ = contexts::get_global_default_context();
  std::vector<std::string> arguments_;
  bool use_global_arguments_ = true;
};

}  // namespace rclcpp
