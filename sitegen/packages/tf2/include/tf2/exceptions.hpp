#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace tf2
{

enum class TF2Error : std::uint8_t
{
  TF2_NO_ERROR = 0,
  TF2_LOOKUP_ERROR = 1,
  TF2_CONNECTIVITY_ERROR = 2,
  TF2_EXTRAPOLATION_ERROR = 3,
  TF2_INVALID_ARGUMENT_ERROR = 4,
  TF2_TIMEOUT_ERROR = 5,
  TF2_TRANSFORM_ERROR = 6,
  TF2_BACKWARD_EXTRAPOLATION_ERROR = 7,
  TF2_FORWARD_EXTRAPOLATION_ERROR = 8,
  TF2_NO_DATA_FOR_EXTRAPOLATION_ERROR = 9,
};

/// The base class of these exceptions.
class TransformException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Both frames exist, but no transforms connect them.
class ConnectivityException : public TransformException
{
public:
  using TransformException::TransformException;
};

/// A frame does not exist yet.
class LookupException : public TransformException
{
public:
  using TransformException::TransformException;
};

/// A time is outside the buffered times.
class ExtrapolationException : public TransformException
{
public:
  using TransformException::TransformException;
};

class BackwardExtrapolationException : public ExtrapolationException
{
public:
  using ExtrapolationException::ExtrapolationException;
};

class ForwardExtrapolationException : public ExtrapolationException
{
public:
  using ExtrapolationException::ExtrapolationException;
};

class NoDataForExtrapolationException : public ExtrapolationException
{
public:
  using ExtrapolationException::ExtrapolationException;
};

class InvalidArgumentException : public TransformException
{
public:
  using TransformException::TransformException;
};

class TimeoutException : public TransformException
{
public:
  using TransformException::TransformException;
};

}  // namespace tf2
