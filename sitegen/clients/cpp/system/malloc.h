/* What glibc has in <malloc.h> and Emscripten lacks. */
#ifndef SITEGEN_MALLOC_H_
#define SITEGEN_MALLOC_H_
#pragma GCC system_header /* include_next is an extension */

#include_next <malloc.h>

/* A page has one arena, maps no memory and keeps what it has, so these have no effect. */
#define M_TOP_PAD -102
#define M_MMAP_MAX -4
#define M_CHECK_ACTION -5
#define M_PERTURB -6
#define M_ARENA_TEST -7
#define M_ARENA_MAX -8
#define M_MXFAST 1

struct mallinfo2
{
  size_t arena;
  size_t ordblks;
  size_t smblks;
  size_t hblks;
  size_t hblkhd;
  size_t usmblks;
  size_t fsmblks;
  size_t uordblks;
  size_t fordblks;
  size_t keepcost;
};

#ifdef __cplusplus
extern "C" {
#endif

static inline int sitegen_mallopt(int parameter, int value)
{
  return parameter == M_MXFAST || parameter < M_MMAP_THRESHOLD ? 1 : mallopt(parameter, value);
}

static inline struct mallinfo2 mallinfo2(void)
{
  const struct mallinfo found = mallinfo();
  struct mallinfo2 result = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  result.arena = (size_t)found.arena;
  result.ordblks = (size_t)found.ordblks;
  result.hblks = (size_t)found.hblks;
  result.hblkhd = (size_t)found.hblkhd;
  result.uordblks = (size_t)found.uordblks;
  result.fordblks = (size_t)found.fordblks;
  result.keepcost = (size_t)found.keepcost;
  return result;
}

static inline int malloc_trim(size_t pad)
{
  (void)pad;
  return 0; /* nothing can be released */
}

#ifdef __cplusplus
}
#endif

#define mallopt sitegen_mallopt

#endif
