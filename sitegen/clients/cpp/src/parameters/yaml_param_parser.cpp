#include "rcl_yaml_param_parser/parser.h"

#include <cstring>
#include <string>

#include "rclcpp/detail/parameter_file.hpp"
#include "rclcpp/exceptions.hpp"
#include "rcutils/error_handling.h"

namespace
{

template<class T>
T * make(const rcutils_allocator_t & allocator, std::size_t count = 1)
{
  return static_cast<T *>(allocator.zero_allocate(count, sizeof(T), allocator.state));
}

void release(const rcutils_allocator_t & allocator, void * pointer)
{
  if (pointer) {allocator.deallocate(pointer, allocator.state);}
}

char * copy(const rcutils_allocator_t & allocator, const std::string & text)
{
  char * made = make<char>(allocator, text.size() + 1);
  std::memcpy(made, text.data(), text.size());
  return made;
}

template<class T>
T * copy_value(const rcutils_allocator_t & allocator, T value)
{
  T * made = make<T>(allocator);
  *made = value;
  return made;
}

template<class ArrayT, class VectorT>
ArrayT * copy_array(const rcutils_allocator_t & allocator, const VectorT & values)
{
  auto * array = make<ArrayT>(allocator);
  array->size = values.size();
  array->values = static_cast<decltype(array->values)>(
    allocator.zero_allocate(values.size(), sizeof(*array->values), allocator.state));
  for (std::size_t i = 0; i < values.size(); ++i) {array->values[i] = values[i];}
  return array;
}

rcutils_string_array_t * copy_strings(
  const rcutils_allocator_t & allocator, const std::vector<std::string> & values)
{
  auto * array = make<rcutils_string_array_t>(allocator);
  array->allocator = allocator;
  array->size = values.size();
  array->data = make<char *>(allocator, values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {array->data[i] = copy(allocator, values[i]);}
  return array;
}

void clear(const rcutils_allocator_t & allocator, rcl_variant_t & variant)
{
  const auto release_array = [&allocator](auto * array) {
      if (array) {release(allocator, array->values);}
      release(allocator, array);
    };
  release(allocator, variant.bool_value);
  release(allocator, variant.integer_value);
  release(allocator, variant.double_value);
  release(allocator, variant.string_value);
  release_array(variant.byte_array_value);
  release_array(variant.bool_array_value);
  release_array(variant.integer_array_value);
  release_array(variant.double_array_value);
  if (auto * strings = variant.string_array_value) {
    for (std::size_t i = 0; i < strings->size; ++i) {release(allocator, strings->data[i]);}
    release(allocator, strings->data);
    release(allocator, strings);
  }
  variant = {};
}

void assign(
  const rcutils_allocator_t & allocator, rcl_variant_t & variant,
  const rclcpp::ParameterValue & value)
{
  clear(allocator, variant);
  const auto message = value.to_value_msg();
  switch (value.get_type()) {
    case rclcpp::PARAMETER_BOOL:
      variant.bool_value = copy_value(allocator, message.bool_value);
      break;
    case rclcpp::PARAMETER_INTEGER:
      variant.integer_value = copy_value(allocator, message.integer_value);
      break;
    case rclcpp::PARAMETER_DOUBLE:
      variant.double_value = copy_value(allocator, message.double_value);
      break;
    case rclcpp::PARAMETER_STRING:
      variant.string_value = copy(allocator, message.string_value);
      break;
    case rclcpp::PARAMETER_BOOL_ARRAY:
      variant.bool_array_value = copy_array<rcl_bool_array_t>(allocator, message.bool_array_value);
      break;
    case rclcpp::PARAMETER_INTEGER_ARRAY:
      variant.integer_array_value =
        copy_array<rcl_int64_array_t>(allocator, message.integer_array_value);
      break;
    case rclcpp::PARAMETER_DOUBLE_ARRAY:
      variant.double_array_value =
        copy_array<rcl_double_array_t>(allocator, message.double_array_value);
      break;
    case rclcpp::PARAMETER_STRING_ARRAY:
      variant.string_array_value = copy_strings(allocator, message.string_array_value);
      break;
    default:
      break;  // an empty list
  }
}

/// The index of `name` in a list, or the length of the list if it is not in it.
std::size_t find(char * const * names, std::size_t size, const char * name)
{
  std::size_t i = 0;
  while (i < size && std::strcmp(names[i], name) != 0) {++i;}
  return i;
}

/// Grow an array by one element.
template<class T>
void grow(const rcutils_allocator_t & allocator, T *& list, std::size_t size)
{
  list = static_cast<T *>(
    allocator.reallocate(list, (size + 1) * sizeof(T), allocator.state));
  list[size] = T();
}

template<class ReadT>
bool attempt(ReadT read)
{
  try {
    read();
    return true;
  } catch (const rclcpp::exceptions::RCLError & error) {
    RCUTILS_SET_ERROR_MSG(error.what());
    return false;
  }
}

}  // namespace

extern "C" {

rcl_params_t * rcl_yaml_node_struct_init(const rcutils_allocator_t allocator)
{
  auto * params = make<rcl_params_t>(allocator);
  if (!params) {return nullptr;}
  params->allocator = allocator;
  // Arrays are not null even if they are empty.
  grow(allocator, params->node_names, 0);
  grow(allocator, params->params, 0);
  params->capacity_nodes = 1;
  return params;
}

void rcl_yaml_node_struct_fini(rcl_params_t * params_st)
{
  if (!params_st) {return;}
  const auto allocator = params_st->allocator;
  for (std::size_t n = 0; n < params_st->num_nodes; ++n) {
    auto & node = params_st->params[n];
    for (std::size_t i = 0; i < node.num_params; ++i) {
      release(allocator, node.parameter_names[i]);
      clear(allocator, node.parameter_values[i]);
    }
    release(allocator, node.parameter_names);
    release(allocator, node.parameter_values);
    release(allocator, params_st->node_names[n]);
  }
  release(allocator, params_st->node_names);
  release(allocator, params_st->params);
  release(allocator, params_st);
}

rcl_variant_t * rcl_yaml_node_struct_get(
  const char * node_name, const char * param_name, rcl_params_t * params_st)
{
  if (!node_name || !param_name || !params_st) {return nullptr;}
  const auto allocator = params_st->allocator;
  const std::size_t n = find(params_st->node_names, params_st->num_nodes, node_name);
  if (n == params_st->num_nodes) {
    grow(allocator, params_st->node_names, n);
    grow(allocator, params_st->params, n);
    params_st->node_names[n] = copy(allocator, node_name);
    params_st->capacity_nodes = ++params_st->num_nodes;
  }
  auto & node = params_st->params[n];
  const std::size_t i = find(node.parameter_names, node.num_params, param_name);
  if (i == node.num_params) {
    grow(allocator, node.parameter_names, i);
    grow(allocator, node.parameter_values, i);
    node.parameter_names[i] = copy(allocator, param_name);
    node.capacity_params = ++node.num_params;
  }
  return &node.parameter_values[i];
}

bool rcl_parse_yaml_file(const char * file_path, rcl_params_t * params_st)
{
  RCUTILS_CHECK_ARGUMENT_FOR_NULL(file_path, false);
  RCUTILS_CHECK_ARGUMENT_FOR_NULL(params_st, false);
  return attempt([&] {
             for (const auto & node : rclcpp::detail::read_parameter_file(file_path)) {
               for (const auto & one : node.parameters) {
                 auto * variant = rcl_yaml_node_struct_get(
                   node.node.c_str(), one.get_name().c_str(), params_st);
                 assign(params_st->allocator, *variant, one.get_parameter_value());
               }
             }
           });
}

bool rcl_parse_yaml_value(
  const char * node_name, const char * param_name, const char * yaml_value,
  rcl_params_t * params_st)
{
  RCUTILS_CHECK_ARGUMENT_FOR_NULL(node_name, false);
  RCUTILS_CHECK_ARGUMENT_FOR_NULL(param_name, false);
  RCUTILS_CHECK_ARGUMENT_FOR_NULL(yaml_value, false);
  RCUTILS_CHECK_ARGUMENT_FOR_NULL(params_st, false);
  return attempt([&] {
             const auto value =
             rclcpp::detail::parameter_value(rclcpp::detail::read_yaml(yaml_value));
             auto * variant = rcl_yaml_node_struct_get(node_name, param_name, params_st);
             assign(params_st->allocator, *variant, value);
           });
}

}  // extern "C"
