#pragma once

#include <type_traits>

namespace rclcpp
{

/// The conversion between a class of the user and a message. Specialize it with `is_specialized`
/// true, `custom_type`, `ros_message_type`, `convert_to_ros_message` and `convert_to_custom`.
template<typename CustomType, typename ROSMessageType = void, class Enable = void>
struct TypeAdapter
{
  using is_specialized = std::false_type;
  using custom_type = CustomType;
  using ros_message_type = CustomType;
};

/// Whether a type is a TypeAdapter.
template<typename T>
struct is_type_adapter : std::false_type {};
template<typename CustomType, typename ROSMessageType>
struct is_type_adapter<TypeAdapter<CustomType, ROSMessageType>> : std::true_type {};

/// The adapter for a type that is used without one.
template<typename CustomType>
struct ImplicitTypeAdapter
{
  using is_specialized = std::false_type;
};

template<typename CustomType>
struct adapt_type
{
  template<typename ROSMessageType>
  using as = TypeAdapter<CustomType, ROSMessageType>;
};

namespace detail
{

template<class T, class = void>
struct AdapterOf
{
  using type = TypeAdapter<T>;
};
template<class Custom, class Message>
struct AdapterOf<TypeAdapter<Custom, Message>, void>
{
  using type = TypeAdapter<Custom, Message>;
};
template<class T>
struct AdapterOf<T, std::enable_if_t<ImplicitTypeAdapter<T>::is_specialized::value>>
{
  using type = ImplicitTypeAdapter<T>;
};

template<class T>
using Adapter = typename AdapterOf<T>::type;
template<class T>
constexpr bool is_adapted = Adapter<T>::is_specialized::value;
template<class T>
using custom_type = typename Adapter<T>::custom_type;
template<class T>
using ros_type = typename Adapter<T>::ros_message_type;

}  // namespace detail
}  // namespace rclcpp

#define RCLCPP_USING_CUSTOM_TYPE_AS_ROS_MESSAGE_TYPE(CustomType, ROSMessageType) \
  template<> \
  struct rclcpp::ImplicitTypeAdapter<CustomType> \
    : public rclcpp::TypeAdapter<CustomType, ROSMessageType> \
  { \
    static_assert( \
      is_specialized::value, "Cannot use custom type as ros type when there is no TypeAdapter"); \
  }
