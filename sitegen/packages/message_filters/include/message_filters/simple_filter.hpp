#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "message_filters/connection.hpp"
#include "message_filters/detail/signal.hpp"
#include "message_filters/message_event.hpp"

namespace message_filters
{

/// The common part of filters with one output: callbacks, and a name.
template<class M>
class SimpleFilter
{
public:
  using MConstPtr = std::shared_ptr<M const>;
  using Callback = std::function<void (const MConstPtr &)>;
  using EventType = MessageEvent<M const>;
  using EventCallback = std::function<void (const EventType &)>;

  SimpleFilter() = default;
  SimpleFilter(const SimpleFilter &) = delete;
  SimpleFilter & operator=(const SimpleFilter &) = delete;

  template<typename C>
  Connection registerCallback(C callback) {return signal_.add(std::move(callback));}
  template<typename C, typename T>
  Connection registerCallback(C callback, T * object)
  {
    return signal_.add(detail::bound(callback, object));
  }

  void setName(const std::string & name) {name_ = name;}
  const std::string & getName() const {return name_;}

protected:
  void signalMessage(const MConstPtr & message) {signal_.call(EventType(message));}
  void signalMessage(const EventType & event) {signal_.call(event);}

private:
  detail::Signal<M> signal_;
  std::string name_;
};

}  // namespace message_filters
