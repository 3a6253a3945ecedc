/* Included first in programs of `sitegen build --debug`: makes containers check their indices. */
#if __clang_major__ < 15
#define _LIBCPP_DEBUG 0
#elif __clang_major__ < 18
#define _LIBCPP_ENABLE_ASSERTIONS 1
#else
#define _LIBCPP_HARDENING_MODE _LIBCPP_HARDENING_MODE_FAST
#endif
