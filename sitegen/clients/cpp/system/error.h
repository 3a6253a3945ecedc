/* <error.h> of glibc. */
#ifndef SITEGEN_ERROR_H_
#define SITEGEN_ERROR_H_

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

static inline void error(int status, int number, const char * format, ...)
{
  va_list arguments;
  fflush(stdout);
  fprintf(stderr, "%s: ", program_invocation_name);
  va_start(arguments, format);
  vfprintf(stderr, format, arguments);
  va_end(arguments);
  if (number) {fprintf(stderr, ": %s", strerror(number));}
  fputc('\n', stderr);
  if (status) {exit(status);}
}

#ifdef __cplusplus
}
#endif

#endif
