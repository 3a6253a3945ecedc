#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace rclcpp
{
namespace exceptions
{

class UnknownROSArgsError : public std::runtime_error
{
public:
  explicit UnknownROSArgsError(std::vector<std::string> && unknown_ros_args_in);

  const std::vector<std::string> unknown_ros_args;
};

/// An error of the layers below.
class RCLError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Memory that the layers below could not allocate.
class RCLBadAlloc : public RCLError
{
public:
  using RCLError::RCLError;
};

class RCLInvalidROSArgsError : public RCLError
{
public:
  using RCLError::RCLError;
};

class QoSCheckCompatibleException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class MissingGroupNodeException : public std::runtime_error
{
public:
  explicit MissingGroupNodeException(const std::string & object_type)
  : std::runtime_error(
      "cannot determine group or node of the " + object_type + " that is ready") {}
};

/// An argument that the layers below refuse.
class RCLInvalidArgument : public RCLError, public std::invalid_argument
{
public:
  explicit RCLInvalidArgument(const std::string & text)
  : RCLError(text), std::invalid_argument(text) {}
};

class InvalidNodeError : public std::runtime_error
{
public:
  InvalidNodeError()
  : std::runtime_error("node is invalid") {}
};

class InvalidQosOverridesException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The parameter is not declared.
class ParameterNotDeclaredException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class ParameterAlreadyDeclaredException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class InvalidParametersException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class InvalidParameterValueException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class ParameterImmutableException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class ParameterModifiedInCallbackException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class UnsupportedEventTypeException : public RCLError
{
public:
  using RCLError::RCLError;
};

class InvalidEventError : public std::runtime_error
{
public:
  InvalidEventError()
  : std::runtime_error("event is invalid") {}
};

/// A feature that is unsupported in the browser.
class UnimplementedError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class InvalidParameterTypeException : public std::runtime_error
{
public:
  InvalidParameterTypeException(const std::string & name, const std::string & message)
  : std::runtime_error("parameter '" + name + "' has invalid type: " + message) {}
};

class ParameterUninitializedException : public std::runtime_error
{
public:
  explicit ParameterUninitializedException(const std::string & name)
  : std::runtime_error("parameter '" + name + "' is not initialized") {}
};

class NoParameterOverrideProvided : public std::runtime_error
{
public:
  explicit NoParameterOverrideProvided(const std::string & name)
  : std::runtime_error("parameter '" + name + "' requires an user provided parameter override") {}
};

class UninitializedStaticallyTypedParameterException : public std::runtime_error
{
public:
  explicit UninitializedStaticallyTypedParameterException(const std::string & name)
  : std::runtime_error("parameter '" + name + "' has a fixed type and no value") {}
};

class UnknownTypeError : public std::runtime_error
{
public:
  explicit UnknownTypeError(const std::string & type)
  : std::runtime_error("unknown type: " + type) {}
};

class EventNotRegisteredError : public std::runtime_error
{
public:
  EventNotRegisteredError()
  : std::runtime_error("event is not registered") {}
};

class InvalidServiceTypeError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class NameValidationError : public std::invalid_argument
{
public:
  /// `invalid_index` is the position of the fault in `name`.
  NameValidationError(
    const char * name_type, const char * name, const char * error_msg,
    std::size_t invalid_index);

  const std::string name_type;
  const std::string name;
  const std::string error_msg;
  const std::size_t invalid_index;
};

class InvalidNodeNameError : public NameValidationError
{
public:
  InvalidNodeNameError(const char * node_name, const char * error_msg, std::size_t invalid_index)
  : NameValidationError("node name", node_name, error_msg, invalid_index) {}
};

class InvalidNamespaceError : public NameValidationError
{
public:
  InvalidNamespaceError(
    const char * name_space, const char * error_msg, std::size_t invalid_index)
  : NameValidationError("namespace", name_space, error_msg, invalid_index) {}
};

class InvalidTopicNameError : public NameValidationError
{
public:
  InvalidTopicNameError(
    const char * topic_name, const char * error_msg, std::size_t invalid_index)
  : NameValidationError("topic name", topic_name, error_msg, invalid_index) {}
};

class InvalidServiceNameError : public NameValidationError
{
public:
  InvalidServiceNameError(
    const char * service_name, const char * error_msg, std::size_t invalid_index)
  : NameValidationError("service name", service_name, error_msg, invalid_index) {}
};

}  // namespace exceptions

// Upstream has it in either namespace, depending on the release.
using exceptions::UnsupportedEventTypeException;
}  // namespace rclcpp
