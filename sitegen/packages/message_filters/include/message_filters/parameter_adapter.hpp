#pragma once

#include <memory>
#include <type_traits>

#include "message_filters/message_event.hpp"

namespace message_filters
{

namespace detail
{

template<typename M, typename ParameterT, bool IsConst>
struct Adapter
{
  using Message = std::remove_cv_t<std::remove_reference_t<M>>;
  using Event = MessageEvent<Message const>;
  using Parameter = ParameterT;
  static const bool is_const = IsConst;
};

}  // namespace detail

/// How a callback with a parameter of type `M` receives the message of an event.
template<typename M>
struct ParameterAdapter : detail::Adapter<M, M, true>
{
  static M getParameter(const MessageEvent<std::remove_cv_t<M> const> & event)
  {
    return *event.getMessage();
  }
};
template<typename M>
struct ParameterAdapter<const M &> : detail::Adapter<M, const M &, true>
{
  static const M & getParameter(const MessageEvent<M const> & event)
  {
    return *event.getMessage();
  }
};
template<typename M>
struct ParameterAdapter<std::shared_ptr<M const>>
  : detail::Adapter<M, std::shared_ptr<M const>, true>
{
  static std::shared_ptr<M const> getParameter(const MessageEvent<M const> & event)
  {
    return event.getMessage();
  }
};
template<typename M>
struct ParameterAdapter<const std::shared_ptr<M const> &>
  : ParameterAdapter<std::shared_ptr<M const>> {};
template<typename M>
struct ParameterAdapter<std::shared_ptr<M>> : detail::Adapter<M, std::shared_ptr<M>, false>
{
  /// A copy: other callbacks have the same message.
  static std::shared_ptr<M> getParameter(const MessageEvent<M const> & event)
  {
    return std::make_shared<M>(*event.getMessage());
  }
};
template<typename M>
struct ParameterAdapter<const std::shared_ptr<M> &> : ParameterAdapter<std::shared_ptr<M>> {};
template<typename M>
struct ParameterAdapter<const MessageEvent<M const> &>
  : detail::Adapter<M, const MessageEvent<M const> &, true>
{
  static const MessageEvent<M const> & getParameter(const MessageEvent<M const> & event)
  {
    return event;
  }
};

}  // namespace message_filters
