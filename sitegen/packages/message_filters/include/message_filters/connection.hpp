#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <utility>

namespace message_filters
{

/// The result of registerCallback(), with which the callback is removed.
class Connection
{
public:
  using VoidDisconnectFunction = std::function<void ()>;

  Connection() = default;
  Connection(VoidDisconnectFunction disconnect)  // NOLINT(runtime/explicit)
  : disconnect_(std::move(disconnect)) {}

  void disconnect()
  {
    if (disconnect_) {std::exchange(disconnect_, nullptr)();}
  }

private:
  VoidDisconnectFunction disconnect_;
};

}  // namespace message_filters
