/* <execinfo.h> of glibc. A page has no addresses of callers, so backtraces are empty. */
#ifndef SITEGEN_EXECINFO_H_
#define SITEGEN_EXECINFO_H_

#include <stdlib.h>

#ifdef __cplusplus
extern "C" {
#endif

static inline int backtrace(void ** buffer, int size)
{
  (void)buffer;
  (void)size;
  return 0;
}

/* The caller frees the result. */
static inline char ** backtrace_symbols(void * const * buffer, int size)
{
  (void)buffer;
  (void)size;
  return (char **)calloc(1, sizeof(char *));
}

static inline void backtrace_symbols_fd(void * const * buffer, int size, int fd)
{
  (void)buffer;
  (void)size;
  (void)fd;
}

#ifdef __cplusplus
}
#endif

#endif
