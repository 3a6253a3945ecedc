#pragma once

#if __cplusplus > 201703L
#include <bit>
#endif

namespace rcpputils
{

#if __cplusplus > 201703L
using std::endian;
#else
enum class endian
{
  little = __ORDER_LITTLE_ENDIAN__,
  big = __ORDER_BIG_ENDIAN__,
  native = __BYTE_ORDER__
};
#endif

}  // namespace rcpputils
