#pragma once

#include "rclcpp/context.hpp"

namespace rclcpp
{
namespace contexts
{

class DefaultContext : public Context
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(DefaultContext)
};

DefaultContext::SharedPtr get_global_default_context();

namespace default_context
{
using contexts::DefaultContext;
using contexts::get_global_default_context;
}  // namespace default_context

}  // namespace contexts
}  // namespace rclcpp
