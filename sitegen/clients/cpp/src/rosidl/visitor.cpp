// Serialize and deserialize messages that are C structs.
#include <algorithm>
#include <stdexcept>
#include <string>

#include "fields.hpp"
#include "rosidl_typesupport_sitegen_cpp/cdr.hpp"
#include "rosidl_typesupport_sitegen_cpp/message_type_support.hpp"

namespace rosidl_typesupport_sitegen_cpp
{

using namespace sitegen_c;

static_assert(
  sizeof(rosidl_sitegen__Members) == sizeof(MessageMembers) &&
  offsetof(rosidl_sitegen__Members, visit) == offsetof(MessageMembers, visit) &&
  offsetof(rosidl_sitegen__Members, destroy) == offsetof(MessageMembers, destroy));

namespace
{

// The least number of bytes that a value takes when it is serialized.
std::size_t least_size_of(const Field & field)
{
  if (field.type != kNested) {
    return field.type == kWchar || !is_plain(field) ? 4 : size_of(field);
  }
  std::size_t sum = 0;
  for (std::size_t i = 0; i < field.nested->count; ++i) {
    const Field & one = field.nested->fields[i];
    const std::size_t count = one.shape == rosidl_sitegen__ARRAY ? one.capacity : 1;
    sum += is_sequence(one) ? 4 : count * least_size_of(one);
  }
  return std::max<std::size_t>(sum, 1);
}

}  // namespace

/// Visits the values of C structs.
struct CVisitor
{
  Cdr & cdr;

  void fields(const Struct & type, void * message) const
  {
    for (std::size_t i = 0; i < type.count && cdr.ok_; ++i) {
      const Field & field = type.fields[i];
      if (is_sequence(field)) {
        sequence(field, *reinterpret_cast<Sequence *>(at(message, field.offset)));
      } else {
        elements(field, at(message, field.offset), count_of(field));
      }
    }
  }

  void sequence(const Field & field, Sequence & values) const
  {
    const std::size_t bound = field.shape == rosidl_sitegen__BOUNDED ? field.capacity : SIZE_MAX;
    const bool reads = cdr.mode_ == Cdr::Mode::kRead;
    if (!reads && values.size > bound) {
      throw std::length_error(
        "the length of a sequence is " + std::to_string(values.size) + "; the maximum is " +
        std::to_string(bound));
    }
    const std::size_t count = cdr.length(values.size);
    if (reads) {
      // The length may be wrong: allocate only for as many elements as there are bytes.
      cdr.ok_ = cdr.ok_ && count <= bound && count <= cdr.left() / least_size_of(field);
      if (!cdr.ok_) {return;}
      fini_sequence(field, values);
      cdr.ok_ = init_sequence(field, values, count);
    }
    elements(field, values.data, count);
  }

  void elements(const Field & field, void * values, std::size_t count) const
  {
    const std::size_t size = size_of(field);
    if (is_plain(field) && field.type != kBool && field.type != kWchar) {
      if (count) {cdr.block(values, size, count);}
      return;
    }
    for (std::size_t i = 0; i < count && cdr.ok_; ++i) {
      void * value = at(values, i * size);
      if (field.type == kNested) {
        fields(*field.nested, value);
      } else if (field.type == kBool) {
        cdr(*static_cast<bool *>(value));
      } else if (field.type == kWchar) {
        cdr(*static_cast<char16_t *>(value));
      } else if (is_wide(field)) {
        text<std::u16string>(
          field, *static_cast<U16String *>(value), rosidl_runtime_c__U16String__assignn);
      } else {
        text<std::string>(field, *static_cast<String *>(value), rosidl_runtime_c__String__assignn);
      }
    }
  }

  template<class Text, class CText, class Unit>
  void text(const Field & field, CText & value, bool (* assign)(CText *, const Unit *, size_t)) const
  {
    Text copy(reinterpret_cast<const typename Text::value_type *>(value.data), value.size);
    if (field.bound) {
      cdr.bounded(copy, field.bound);
    } else {
      cdr(copy);
    }
    if (cdr.mode_ == Cdr::Mode::kRead && cdr.ok_) {
      cdr.ok_ = assign(&value, reinterpret_cast<const Unit *>(copy.data()), copy.size());
    }
  }
};

}  // namespace rosidl_typesupport_sitegen_cpp

extern "C" void rosidl_sitegen__visit(
  const rosidl_sitegen__Struct * type, void * cdr, void * message)
{
  using rosidl_typesupport_sitegen_cpp::Cdr;
  rosidl_typesupport_sitegen_cpp::CVisitor{*static_cast<Cdr *>(cdr)}.fields(*type, message);
}
