#pragma once

#include <memory>

#include "message_filters/simple_filter.hpp"

namespace message_filters
{

/// A filter that passes on every message that is added.
template<typename M>
class PassThrough : public SimpleFilter<M>
{
public:
  using MConstPtr = std::shared_ptr<M const>;
  using EventType = MessageEvent<M const>;

  PassThrough() = default;
  template<typename F>
  PassThrough(F & filter) {connectInput(filter);}
  ~PassThrough() {connection_.disconnect();}

  template<class F>
  void connectInput(F & filter)
  {
    connection_.disconnect();
    connection_ = filter.registerCallback([this](const EventType & event) {add(event);});
  }

  void add(const MConstPtr & message) {this->signalMessage(message);}
  void add(const EventType & event) {this->signalMessage(event);}

private:
  Connection connection_;
};

}  // namespace message_filters
