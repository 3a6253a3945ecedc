// Service types by name: those whose headers the program includes.
#pragma once

#include <memory>
#include <string>

#include "rosidl_typesupport_sitegen_cpp/message_type_support.hpp"

namespace rclcpp
{
namespace detail
{

struct NamedService
{
  const rosidl_typesupport_sitegen_cpp::MessageMembers * request;
  const rosidl_typesupport_sitegen_cpp::MessageMembers * response;
};

/// Throws std::runtime_error for an unknown name.
const NamedService & named_service(const std::string & name);

/// Create a message of a type.
inline std::shared_ptr<void> make_message(const rosidl_typesupport_sitegen_cpp::MessageMembers & type)
{
  return {type.create(), type.destroy};
}

}  // namespace detail
}  // namespace rclcpp
