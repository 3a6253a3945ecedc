// Type supports in C, and hashes of types.
#include <cstdio>
#include <cstring>

#include "rcutils/types/rcutils_ret.h"
#include "rosidl_typesupport_sitegen_c/message.h"

namespace
{

template<class Handle>
const Handle * find(const Handle * handle, const char * identifier)
{
  const bool fits = handle && identifier && handle->typesupport_identifier &&
    std::strcmp(handle->typesupport_identifier, identifier) == 0;
  return fits ? handle : nullptr;
}

constexpr char kPrefix[] = "RIHS01_";
constexpr std::size_t kPrefixSize = sizeof(kPrefix) - 1;

int digit(char letter)
{
  if (letter >= '0' && letter <= '9') {return letter - '0';}
  if (letter >= 'a' && letter <= 'f') {return letter - 'a' + 10;}
  return letter >= 'A' && letter <= 'F' ? letter - 'A' + 10 : -1;
}

}  // namespace

extern "C" {

const rosidl_runtime_c__type_description__TypeDescription rosidl_sitegen__description = {};
const rosidl_runtime_c__type_description__TypeSource rosidl_sitegen__source = {};
const rosidl_runtime_c__type_description__TypeSource__Sequence rosidl_sitegen__sources = {};

rosidl_message_type_support_t rosidl_get_zero_initialized_message_type_support_handle()
{
  return {};
}

const rosidl_message_type_support_t * get_message_typesupport_handle_function(
  const rosidl_message_type_support_t * handle, const char * identifier)
{
  return find(handle, identifier);
}

const rosidl_service_type_support_t * get_service_typesupport_handle_function(
  const rosidl_service_type_support_t * handle, const char * identifier)
{
  return find(handle, identifier);
}

const rosidl_message_type_support_t * get_message_typesupport_handle(
  const rosidl_message_type_support_t * handle, const char * identifier)
{
  return handle && handle->func ? handle->func(handle, identifier) : nullptr;
}

const rosidl_service_type_support_t * get_service_typesupport_handle(
  const rosidl_service_type_support_t * handle, const char * identifier)
{
  return handle && handle->func ? handle->func(handle, identifier) : nullptr;
}

rosidl_type_hash_t rosidl_get_zero_initialized_type_hash() {return {};}

rcutils_ret_t rosidl_stringify_type_hash(
  const rosidl_type_hash_t * type_hash, rcutils_allocator_t allocator, char ** output_string)
{
  if (!type_hash || !output_string) {return RCUTILS_RET_INVALID_ARGUMENT;}
  const std::size_t size = kPrefixSize + 2 * ROSIDL_TYPE_HASH_SIZE + 1;
  auto text = static_cast<char *>(allocator.allocate(size, allocator.state));
  if (!text) {return RCUTILS_RET_BAD_ALLOC;}
  std::snprintf(text, size, "RIHS%02x_", type_hash->version);
  for (std::size_t i = 0; i < ROSIDL_TYPE_HASH_SIZE; ++i) {
    std::snprintf(text + kPrefixSize + 2 * i, 3, "%02x", type_hash->value[i]);
  }
  *output_string = text;
  return RCUTILS_RET_OK;
}

rcutils_ret_t rosidl_parse_type_hash_string(const char * text, rosidl_type_hash_t * hash_out)
{
  if (!text || !hash_out) {return RCUTILS_RET_INVALID_ARGUMENT;}
  *hash_out = {};
  if (std::strncmp(text, kPrefix, kPrefixSize) != 0 ||
    std::strlen(text) != kPrefixSize + 2 * ROSIDL_TYPE_HASH_SIZE)
  {
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  hash_out->version = 1;
  for (std::size_t i = 0; i < ROSIDL_TYPE_HASH_SIZE; ++i) {
    const char * pair = text + kPrefixSize + 2 * i;
    if (digit(pair[0]) < 0 || digit(pair[1]) < 0) {return RCUTILS_RET_INVALID_ARGUMENT;}
    hash_out->value[i] = static_cast<uint8_t>(digit(pair[0]) * 16 + digit(pair[1]));
  }
  return RCUTILS_RET_OK;
}

}
