// Sequences of numbers in C structs.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <type_traits>

#include "rosidl_runtime_c/primitives_sequence_functions.h"

namespace
{

template<class Sequence>
bool init(Sequence * sequence, std::size_t size)
{
  if (!sequence) {return false;}
  using Value = std::remove_pointer_t<decltype(sequence->data)>;
  *sequence = {};
  if (!size) {return true;}
  sequence->data = static_cast<Value *>(std::calloc(size, sizeof(Value)));
  if (!sequence->data) {return false;}
  sequence->size = sequence->capacity = size;
  return true;
}

template<class Sequence>
void fini(Sequence * sequence)
{
  if (!sequence) {return;}
  std::free(sequence->data);
  *sequence = {};
}

template<class Sequence>
bool equal(const Sequence * left, const Sequence * right)
{
  return left && right && left->size == right->size &&
         std::equal(left->data, left->data + left->size, right->data);
}

template<class Sequence>
bool copy(const Sequence * input, Sequence * output)
{
  if (!input || !output) {return false;}
  if (output->capacity < input->size) {
    Sequence larger;
    if (!init(&larger, input->size)) {return false;}
    fini(output);
    *output = larger;
  }
  output->size = input->size;
  if (input->size) {std::memmove(output->data, input->data, input->size * sizeof(*input->data));}
  return true;
}

}  // namespace

#define SEQUENCE_FUNCTIONS(T) \
  bool T ## __init(T * sequence, size_t size) {return init(sequence, size);} \
  void T ## __fini(T * sequence) {fini(sequence);} \
  bool T ## __are_equal(const T * left, const T * right) {return equal(left, right);} \
  bool T ## __copy(const T * input, T * output) {return copy(input, output);}

extern "C" {

SEQUENCE_FUNCTIONS(rosidl_runtime_c__float__Sequence)
SEQUENCE_FUNCTIONS(rosidl_runtime_c__double__Sequence)
SEQUENCE_FUNCTIONS(rosidl_runtime_c__long_double__Sequence)
SEQUENCE_FUNCTIONS(rosidl_runtime_c__char__Sequence)
SEQUENCE_FUNCTIONS(rosidl_runtime_c__wchar__Sequence)
SEQUENCE_FUNCTIONS(rosidl_runtime_c__boolean__Sequence)
SEQUENCE_FUNCTIONS(rosidl_runtime_c__octet__Sequence)
SEQUENCE_FUNCTIONS(rosidl_runtime_c__uint8__Sequence)
SEQUENCE_FUNCTIONS(rosidl_runtime_c__int8__Sequence)
SEQUENCE_FUNCTIONS(rosidl_runtime_c__uint16__Sequence)
SEQUENCE_FUNCTIONS(rosidl_runtime_c__int16__Sequence)
SEQUENCE_FUNCTIONS(rosidl_runtime_c__uint32__Sequence)
SEQUENCE_FUNCTIONS(rosidl_runtime_c__int32__Sequence)
SEQUENCE_FUNCTIONS(rosidl_runtime_c__uint64__Sequence)
SEQUENCE_FUNCTIONS(rosidl_runtime_c__int64__Sequence)

}
