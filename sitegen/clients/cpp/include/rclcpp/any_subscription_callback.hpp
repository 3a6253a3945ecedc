#pragma once

#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

#include "rclcpp/message_info.hpp"
#include "rclcpp/serialized_message.hpp"

namespace rclcpp
{

/// Any form of a subscription's callback. It takes the message (or its bytes, as a
/// SerializedMessage) by reference, shared or unique pointer, with or without a MessageInfo.
template<class MessageT>
class AnySubscriptionCallback
{
public:
  template<class CallbackT>
  explicit AnySubscriptionCallback(CallbackT && callback)
  {
    using Callback = std::decay_t<CallbackT>;
    if constexpr (takes<Callback, MessageT>) {
      owns_ = !shares<Callback, MessageT>;
      on_message_ = adapt<MessageT>(Callback(std::forward<CallbackT>(callback)));
    } else {
      static_assert(
        takes<Callback, SerializedMessage>,
        "a subscription's callback takes `const T &`, `std::shared_ptr<T>`, "
        "`std::shared_ptr<const T>` or `std::unique_ptr<T>`, T being the message or "
        "rclcpp::SerializedMessage, and perhaps a `const rclcpp::MessageInfo &`");
      on_bytes_ = adapt<SerializedMessage>(Callback(std::forward<CallbackT>(callback)));
    }
  }

  bool wants_bytes() const {return static_cast<bool>(on_bytes_);}

  /// Whether the callback takes ownership of the message.
  bool owns() const {return owns_;}

  void dispatch(std::shared_ptr<MessageT> message, const MessageInfo & info)
  {
    on_message_({std::move(message), nullptr}, info);
  }
  void dispatch_unique(std::unique_ptr<MessageT> message, const MessageInfo & info)
  {
    on_message_({nullptr, std::move(message)}, info);
  }
  void dispatch_bytes(std::shared_ptr<SerializedMessage> bytes, const MessageInfo & info)
  {
    on_bytes_({std::move(bytes), nullptr}, info);
  }

private:
  template<class T>
  struct Given
  {
    std::shared_ptr<T> shared;
    std::unique_ptr<T> unique;  // if it is nobody else's
  };
  template<class T>
  using Handler = std::function<void(Given<T>, const MessageInfo &)>;

  template<class Callback, class ... Args>
  static constexpr bool invocable = std::is_invocable_v<Callback &, Args...>;

  template<class Callback, class T, class ... Info>
  static constexpr bool takes_with =
    invocable<Callback, const T &, Info...> || invocable<Callback, std::shared_ptr<T>, Info...> ||
    invocable<Callback, std::unique_ptr<T>, Info...>;

  template<class Callback, class T, class ... Info>
  static constexpr bool shares_with =
    invocable<Callback, const T &, Info...> ||
    invocable<Callback, std::shared_ptr<const T>, Info...>;

  template<class Callback, class T>
  static constexpr bool shares =
    shares_with<Callback, T> || shares_with<Callback, T, const MessageInfo &>;

  template<class Callback, class T>
  static constexpr bool takes =
    takes_with<Callback, T> || takes_with<Callback, T, const MessageInfo &>;

  template<class T, class Callback>
  static Handler<T> adapt(Callback callback)
  {
    return [callback = std::move(callback)](Given<T> message, const MessageInfo & info) mutable {
             if constexpr (takes_with<Callback, T>) {
               call<T>(callback, std::move(message));
             } else {
               call<T>(callback, std::move(message), info);
             }
           };
  }

  template<class T, class Callback, class ... Info>
  static void call(Callback & callback, Given<T> message, const Info & ... info)
  {
    if constexpr (invocable<Callback, const T &, const Info &...>) {
      callback(static_cast<const T &>(*message.shared), info ...);
    } else if constexpr (invocable<Callback, std::shared_ptr<T>, const Info &...>) {
      if (message.unique) {message.shared = std::move(message.unique);}
      callback(std::move(message.shared), info ...);
    } else {
      if (message.shared) {message.unique = std::make_unique<T>(std::move(*message.shared));}
      callback(std::move(message.unique), info ...);
    }
  }

  bool owns_ = false;
  Handler<MessageT> on_message_;
  Handler<SerializedMessage> on_bytes_;
};

}  // namespace rclcpp
