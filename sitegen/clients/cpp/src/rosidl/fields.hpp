// The fields of C structs of messages, and the sequences among them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "rosidl_typesupport_sitegen_c/message.h"

namespace sitegen_c
{

using Field = rosidl_sitegen__Field;
using Sequence = rosidl_sitegen__Sequence;
using String = rosidl_runtime_c__String;
using Struct = rosidl_sitegen__Struct;
using U16String = rosidl_runtime_c__U16String;

static_assert(sizeof(Sequence) == sizeof(rosidl_runtime_c__double__Sequence));

// type_description_interfaces/msg/FieldType
enum Type : std::uint8_t
{
  kNested = 1, kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kInt64, kUint64, kFloat, kDouble,
  kLongDouble, kChar, kWchar, kBool, kByte, kString, kWstring, kBoundedString = 21,
  kBoundedWstring
};

inline bool is_string(const Field & field)
{
  return field.type == kString || field.type == kBoundedString;
}
inline bool is_wide(const Field & field)
{
  return field.type == kWstring || field.type == kBoundedWstring;
}

inline bool is_plain(const Field & field)
{
  return field.type != kNested && !is_string(field) && !is_wide(field);
}
inline bool is_sequence(const Field & field) {return field.shape >= rosidl_sitegen__BOUNDED;}

// The size of a value in the struct.
inline std::size_t size_of(const Field & field)
{
  switch (field.type) {
    case kNested: return field.nested->size;
    case kInt16: case kUint16: case kWchar: return 2;
    case kInt32: case kUint32: case kFloat: return 4;
    case kInt64: case kUint64: case kDouble: return 8;
    case kLongDouble: return sizeof(long double);
    case kInt8: case kUint8: case kChar: case kBool: case kByte: return 1;
    default: return sizeof(String);
  }
}
static_assert(sizeof(String) == sizeof(U16String));

inline char * at(void * start, std::size_t offset) {return static_cast<char *>(start) + offset;}
inline const char * at(const void * start, std::size_t offset)
{
  return static_cast<const char *>(start) + offset;
}

// The number of values in the struct itself.
inline std::size_t count_of(const Field & field)
{
  return field.shape == rosidl_sitegen__ARRAY ? field.capacity : 1;
}

void fini_sequence(const Field & element, Sequence & sequence);
/// Return false, with an empty sequence, if there is no memory.
bool init_sequence(const Field & element, Sequence & sequence, std::size_t size);

}  // namespace sitegen_c
