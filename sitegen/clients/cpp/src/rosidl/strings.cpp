// The strings of C structs, and sequences of them. Functions return false for null pointers and if
// there is no memory, and then change nothing.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <type_traits>

#include "rosidl_runtime_c/string_functions.h"
#include "rosidl_runtime_c/u16string_functions.h"

namespace
{

// Storage for `size` units and the terminating zero.
template<class String>
bool resize(String * text, std::size_t size)
{
  using Unit = std::remove_pointer_t<decltype(text->data)>;
  if (!text || size > SIZE_MAX / sizeof(Unit) - 1) {return false;}
  void * data = std::realloc(text->data, (size + 1) * sizeof(Unit));
  if (!data) {return false;}
  text->data = static_cast<Unit *>(data);
  text->data[size] = 0;
  text->size = size;
  text->capacity = size + 1;
  return true;
}

template<class String>
bool init(String * text)
{
  if (!text) {return false;}
  text->data = nullptr;
  return resize(text, 0);
}

template<class String>
void fini(String * text)
{
  if (!text) {return;}
  std::free(text->data);
  *text = {};
}

template<class String, class Unit>
bool assign(String * text, const Unit * value, std::size_t size)
{
  // A null pointer would be a mistake even if no unit is read.
  if (!text || !value) {return false;}
  if (value == text->data) {return size <= text->size && resize(text, size);}
  if (!resize(text, size)) {return false;}
  std::memcpy(text->data, value, size * sizeof(Unit));
  return true;
}

template<class String>
bool copy(const String * input, String * output)
{
  return input && assign(output, input->data, input->size);
}

template<class String>
bool equal(const String * left, const String * right)
{
  return left && right && left->size == right->size &&
         std::memcmp(left->data, right->data, left->size * sizeof(*left->data)) == 0;
}

template<class Sequence>
void fini_sequence(Sequence * sequence)
{
  if (!sequence) {return;}
  for (std::size_t i = 0; i < sequence->capacity; ++i) {fini(&sequence->data[i]);}
  std::free(sequence->data);
  *sequence = {};
}

// Make room for `capacity` strings; the new ones are empty.
template<class Sequence>
bool grow(Sequence * sequence, std::size_t capacity)
{
  using String = std::remove_pointer_t<decltype(sequence->data)>;
  if (capacity <= sequence->capacity) {return true;}
  if (capacity > SIZE_MAX / sizeof(String)) {return false;}
  void * data = std::realloc(sequence->data, capacity * sizeof(String));
  if (!data) {return false;}
  sequence->data = static_cast<String *>(data);
  for (; sequence->capacity < capacity; ++sequence->capacity) {
    if (!init(&sequence->data[sequence->capacity])) {return false;}
  }
  return true;
}

template<class Sequence>
bool init_sequence(Sequence * sequence, std::size_t size)
{
  if (!sequence) {return false;}
  *sequence = {};
  if (!grow(sequence, size)) {
    fini_sequence(sequence);
    return false;
  }
  sequence->size = size;
  return true;
}

template<class Sequence>
bool copy_sequence(const Sequence * input, Sequence * output)
{
  if (!input || !output || !grow(output, input->size)) {return false;}
  output->size = input->size;
  for (std::size_t i = 0; i < input->size; ++i) {
    if (!copy(&input->data[i], &output->data[i])) {return false;}
  }
  return true;
}

template<class Sequence>
bool equal_sequences(const Sequence * left, const Sequence * right)
{
  if (!left || !right || left->size != right->size) {return false;}
  for (std::size_t i = 0; i < left->size; ++i) {
    if (!equal(&left->data[i], &right->data[i])) {return false;}
  }
  return true;
}

template<class Sequence>
Sequence * create_sequence(std::size_t size)
{
  auto sequence = static_cast<Sequence *>(std::calloc(1, sizeof(Sequence)));
  if (sequence && !init_sequence(sequence, size)) {
    std::free(sequence);
    return nullptr;
  }
  return sequence;
}

template<class Sequence>
void destroy_sequence(Sequence * sequence)
{
  fini_sequence(sequence);
  std::free(sequence);
}

}  // namespace

// The functions that both kinds of strings have; T is the name of the kind, Unit its unit.
#define STRING_FUNCTIONS(T, Unit) \
  bool T ## __init(T * text) {return init(text);} \
  void T ## __fini(T * text) {fini(text);} \
  bool T ## __copy(const T * input, T * output) {return copy(input, output);} \
  bool T ## __are_equal(const T * left, const T * right) {return equal(left, right);} \
  bool T ## __assignn(T * text, const Unit * value, size_t n) {return assign(text, value, n);} \
  bool T ## __resize(T * text, size_t n) {return resize(text, n);} \
  bool T ## __Sequence__init(T ## __Sequence * sequence, size_t size) \
  {return init_sequence(sequence, size);} \
  void T ## __Sequence__fini(T ## __Sequence * sequence) {fini_sequence(sequence);} \
  bool T ## __Sequence__are_equal(const T ## __Sequence * left, const T ## __Sequence * right) \
  {return equal_sequences(left, right);} \
  bool T ## __Sequence__copy(const T ## __Sequence * input, T ## __Sequence * output) \
  {return copy_sequence(input, output);} \
  T ## __Sequence * T ## __Sequence__create(size_t size) \
  {return create_sequence<T ## __Sequence>(size);} \
  void T ## __Sequence__destroy(T ## __Sequence * sequence) {destroy_sequence(sequence);}

extern "C" {

STRING_FUNCTIONS(rosidl_runtime_c__String, char)
STRING_FUNCTIONS(rosidl_runtime_c__U16String, uint16_t)

bool rosidl_runtime_c__String__assign(rosidl_runtime_c__String * str, const char * value)
{
  return value && assign(str, value, std::strlen(value));
}

bool rosidl_runtime_c__U16String__assign(rosidl_runtime_c__U16String * str, const uint16_t * value)
{
  return value && assign(str, value, rosidl_runtime_c__U16String__len(value));
}

// `n` is the number of bytes.
bool rosidl_runtime_c__U16String__assignn_from_char(
  rosidl_runtime_c__U16String * str, const char * value, size_t n)
{
  if (!str || !value || n % sizeof(uint16_t) || !resize(str, n / sizeof(uint16_t))) {return false;}
  std::memcpy(str->data, value, n);
  return true;
}

size_t rosidl_runtime_c__U16String__len(const uint16_t * value)
{
  size_t length = 0;
  while (value && value[length]) {++length;}
  return length;
}

}
