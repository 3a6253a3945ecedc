#pragma once

#include <type_traits>
#include <utility>

// In no namespace, as upstream.

template<class T, class = void>
struct has_on_activate : std::false_type {};
template<class T>
struct has_on_activate<
  T, std::enable_if_t<std::is_void_v<decltype(std::declval<T>().on_activate())>>>
  : std::true_type {};

template<class T, class = void>
struct has_on_deactivate : std::false_type {};
template<class T>
struct has_on_deactivate<
  T, std::enable_if_t<std::is_void_v<decltype(std::declval<T>().on_deactivate())>>>
  : std::true_type {};

template<class T, class = void>
struct is_manageable_node
  : std::bool_constant<has_on_activate<T>::value && has_on_deactivate<T>::value> {};
