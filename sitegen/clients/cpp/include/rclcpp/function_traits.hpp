#pragma once

#include <cstddef>
#include <functional>
#include <tuple>
#include <type_traits>

namespace rclcpp
{
namespace function_traits
{

/// The parameters and the result of a function, a pointer to one, a lambda or another functor with
/// one operator(). A result of std::bind() has none that can be named.
template<class FunctionT>
struct function_traits
  : function_traits<decltype(&std::remove_reference_t<FunctionT>::operator())> {};

template<class ResultT, class ... Args>
struct function_traits<ResultT(Args...)>
{
  using arguments = std::tuple<Args...>;
  static constexpr std::size_t arity = sizeof...(Args);
  template<std::size_t N>
  using argument_type = std::tuple_element_t<N, arguments>;
  using return_type = ResultT;
};

template<class ResultT, class ... Args>
struct function_traits<ResultT (*)(Args...)> : function_traits<ResultT(Args...)> {};
template<class ResultT, class ... Args>
struct function_traits<ResultT (&)(Args...)> : function_traits<ResultT(Args...)> {};
template<class ClassT, class ResultT, class ... Args>
struct function_traits<ResultT (ClassT::*)(Args...)> : function_traits<ResultT(Args...)> {};
template<class ClassT, class ResultT, class ... Args>
struct function_traits<ResultT (ClassT::*)(Args...) const> : function_traits<ResultT(Args...)> {};

/// A tuple without its first element.
template<class TupleT>
struct tuple_tail;
template<class FirstT, class ... RestT>
struct tuple_tail<std::tuple<FirstT, RestT...>> {using type = std::tuple<RestT...>;};

template<std::size_t Arity, class FunctionT>
struct arity_comparator : std::bool_constant<Arity == function_traits<FunctionT>::arity> {};

template<class FunctionT, class ... Args>
struct check_arguments
  : std::is_same<typename function_traits<FunctionT>::arguments, std::tuple<Args...>> {};

template<class FirstT, class SecondT>
struct same_arguments
  : std::is_same<
    typename function_traits<FirstT>::arguments, typename function_traits<SecondT>::arguments> {};

namespace detail
{

template<class ResultT, class ArgumentsT>
struct StdFunction;
template<class ResultT, class ... Args>
struct StdFunction<ResultT, std::tuple<Args...>> {using type = std::function<ResultT(Args...)>;};

}  // namespace detail

template<class FunctionT, class TraitsT = function_traits<FunctionT>>
struct as_std_function
{
  using type =
    typename detail::StdFunction<
    typename TraitsT::return_type, typename TraitsT::arguments>::type;
};

}  // namespace function_traits
}  // namespace rclcpp
