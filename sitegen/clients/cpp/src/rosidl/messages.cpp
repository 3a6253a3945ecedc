// Messages as C structs: what rosidl_generator_c generates for each message, for all by their tables.
#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "fields.hpp"

namespace sitegen_c
{

namespace
{

// A field of a struct without a message: the elements of a `…__Sequence`.
Field element_of(const Struct & type) {return {0, kNested, rosidl_sitegen__ONE, 0, 0, &type};}

bool init_value(const Field & field, void * value)
{
  if (field.type == kNested) {return rosidl_sitegen__init(field.nested, value);}
  if (is_string(field)) {return rosidl_runtime_c__String__init(static_cast<String *>(value));}
  if (is_wide(field)) {return rosidl_runtime_c__U16String__init(static_cast<U16String *>(value));}
  return true;  // as in native ROS 2, numbers without a default value are left as they are
}

void fini_value(const Field & field, void * value)
{
  if (field.type == kNested) {
    rosidl_sitegen__fini(field.nested, value);
  } else if (is_string(field)) {
    rosidl_runtime_c__String__fini(static_cast<String *>(value));
  } else if (is_wide(field)) {
    rosidl_runtime_c__U16String__fini(static_cast<U16String *>(value));
  }
}

bool copy_value(const Field & field, const void * input, void * output)
{
  if (field.type == kNested) {return rosidl_sitegen__copy(field.nested, input, output);}
  if (is_string(field)) {
    return rosidl_runtime_c__String__copy(
      static_cast<const String *>(input), static_cast<String *>(output));
  }
  if (is_wide(field)) {
    return rosidl_runtime_c__U16String__copy(
      static_cast<const U16String *>(input), static_cast<U16String *>(output));
  }
  std::memmove(output, input, size_of(field));
  return true;
}

template<class Number>
bool equal_numbers(const void * left, const void * right)
{
  return *static_cast<const Number *>(left) == *static_cast<const Number *>(right);
}

bool equal_values(const Field & field, const void * left, const void * right)
{
  switch (field.type) {
    case kNested: return rosidl_sitegen__are_equal(field.nested, left, right);
    case kFloat: return equal_numbers<float>(left, right);
    case kDouble: return equal_numbers<double>(left, right);
    case kLongDouble: return equal_numbers<long double>(left, right);
    case kString: case kBoundedString:
      return rosidl_runtime_c__String__are_equal(
        static_cast<const String *>(left), static_cast<const String *>(right));
    case kWstring: case kBoundedWstring:
      return rosidl_runtime_c__U16String__are_equal(
        static_cast<const U16String *>(left), static_cast<const U16String *>(right));
    default: return std::memcmp(left, right, size_of(field)) == 0;
  }
}

}  // namespace

void fini_sequence(const Field & element, Sequence & sequence)
{
  for (std::size_t i = 0; !is_plain(element) && i < sequence.capacity; ++i) {
    fini_value(element, at(sequence.data, i * size_of(element)));
  }
  std::free(sequence.data);
  sequence = {};
}

namespace
{

// Make room for `capacity` elements; the new ones are initialized.
bool grow(const Field & element, Sequence & sequence, std::size_t capacity)
{
  if (capacity <= sequence.capacity) {return true;}
  const std::size_t size = size_of(element);
  if (capacity > SIZE_MAX / size) {return false;}
  void * data = std::realloc(sequence.data, capacity * size);
  if (!data) {return false;}
  sequence.data = data;
  std::memset(at(data, sequence.capacity * size), 0, (capacity - sequence.capacity) * size);
  for (; sequence.capacity < capacity; ++sequence.capacity) {
    if (!init_value(element, at(data, sequence.capacity * size))) {return false;}
  }
  return true;
}

}  // namespace

bool init_sequence(const Field & element, Sequence & sequence, std::size_t size)
{
  sequence = {};
  if (!grow(element, sequence, size)) {
    fini_sequence(element, sequence);
    return false;
  }
  sequence.size = size;
  return true;
}

namespace
{

bool copy_sequence(const Field & element, const Sequence & input, Sequence & output)
{
  if (!grow(element, output, input.size)) {return false;}
  output.size = input.size;
  for (std::size_t i = 0; i < input.size; ++i) {
    const std::size_t offset = i * size_of(element);
    if (!copy_value(element, at(input.data, offset), at(output.data, offset))) {return false;}
  }
  return true;
}

bool equal_elements(
  const Field & element, const void * left, const void * right, std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t offset = i * size_of(element);
    if (!equal_values(element, at(left, offset), at(right, offset))) {return false;}
  }
  return true;
}

bool equal_sequences(const Field & element, const Sequence & left, const Sequence & right)
{
  return left.size == right.size && equal_elements(element, left.data, right.data, left.size);
}

}  // namespace

}  // namespace sitegen_c

using namespace sitegen_c;

extern "C" {

bool rosidl_sitegen__init(const Struct * type, void * message)
{
  if (!message) {return false;}
  // Those not yet initialized must not be finalized if there is no memory for another one.
  for (std::size_t i = 0; i < type->count; ++i) {
    const Field & field = type->fields[i];
    const std::size_t size = is_sequence(field) ? sizeof(Sequence) : size_of(field) * count_of(field);
    if (is_sequence(field) || !is_plain(field)) {std::memset(at(message, field.offset), 0, size);}
  }
  bool ok = true;
  for (std::size_t i = 0; i < type->count; ++i) {
    const Field & field = type->fields[i];
    for (std::size_t n = 0; n < count_of(field) && ok && !is_sequence(field); ++n) {
      ok = init_value(field, at(message, field.offset + n * size_of(field)));
    }
  }
  ok = ok && (!type->set_defaults || type->set_defaults(message));
  if (!ok) {rosidl_sitegen__fini(type, message);}
  return ok;
}

void rosidl_sitegen__fini(const Struct * type, void * message)
{
  if (!message) {return;}
  for (std::size_t i = 0; i < type->count; ++i) {
    const Field & field = type->fields[i];
    if (is_sequence(field)) {
      fini_sequence(field, *reinterpret_cast<Sequence *>(at(message, field.offset)));
      continue;
    }
    for (std::size_t n = 0; n < count_of(field); ++n) {
      fini_value(field, at(message, field.offset + n * size_of(field)));
    }
  }
}

void * rosidl_sitegen__create(const Struct * type)
{
  void * message = std::calloc(1, type->size);
  if (message && !rosidl_sitegen__init(type, message)) {
    std::free(message);
    return nullptr;
  }
  return message;
}

void rosidl_sitegen__destroy(const Struct * type, void * message)
{
  rosidl_sitegen__fini(type, message);
  std::free(message);
}

bool rosidl_sitegen__are_equal(const Struct * type, const void * left, const void * right)
{
  if (!left || !right) {return false;}
  return std::all_of(
    type->fields, type->fields + type->count, [left, right](const Field & field) {
      const void * one = at(left, field.offset);
      const void * other = at(right, field.offset);
      return is_sequence(field) ?
             equal_sequences(
        field, *static_cast<const Sequence *>(one), *static_cast<const Sequence *>(other)) :
             equal_elements(field, one, other, count_of(field));
    });
}

bool rosidl_sitegen__copy(const Struct * type, const void * input, void * output)
{
  if (!input || !output) {return false;}
  return std::all_of(
    type->fields, type->fields + type->count, [input, output](const Field & field) {
      if (is_sequence(field)) {
        return copy_sequence(
          field, *reinterpret_cast<const Sequence *>(at(input, field.offset)),
          *reinterpret_cast<Sequence *>(at(output, field.offset)));
      }
      bool ok = true;
      for (std::size_t n = 0; n < count_of(field) && ok; ++n) {
        const std::size_t offset = field.offset + n * size_of(field);
        ok = copy_value(field, at(input, offset), at(output, offset));
      }
      return ok;
    });
}

bool rosidl_sitegen__sequence_init(const Struct * type, void * sequence, size_t size)
{
  return sequence && init_sequence(element_of(*type), *static_cast<Sequence *>(sequence), size);
}

void rosidl_sitegen__sequence_fini(const Struct * type, void * sequence)
{
  if (sequence) {fini_sequence(element_of(*type), *static_cast<Sequence *>(sequence));}
}

void * rosidl_sitegen__sequence_create(const Struct * type, size_t size)
{
  void * sequence = std::calloc(1, sizeof(Sequence));
  if (sequence && !rosidl_sitegen__sequence_init(type, sequence, size)) {
    std::free(sequence);
    return nullptr;
  }
  return sequence;
}

void rosidl_sitegen__sequence_destroy(const Struct * type, void * sequence)
{
  rosidl_sitegen__sequence_fini(type, sequence);
  std::free(sequence);
}

bool rosidl_sitegen__sequences_are_equal(const Struct * type, const void * left, const void * right)
{
  return left && right && equal_sequences(
    element_of(*type), *static_cast<const Sequence *>(left), *static_cast<const Sequence *>(right));
}

bool rosidl_sitegen__sequence_copy(const Struct * type, const void * input, void * output)
{
  return input && output && copy_sequence(
    element_of(*type), *static_cast<const Sequence *>(input), *static_cast<Sequence *>(output));
}

}
