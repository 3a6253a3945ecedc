/* <sys/syscall.h> with the only call that a page has: programs ask for the number of a thread. */
#ifndef SITEGEN_SYS_SYSCALL_H_
#define SITEGEN_SYS_SYSCALL_H_
#pragma GCC system_header /* include_next is an extension */

#include_next <sys/syscall.h>
#include <errno.h>
#include <sys/types.h>

#ifdef __cplusplus
extern "C" {
#endif

pid_t gettid(void);

#ifndef SYS_gettid
#define SYS_gettid 186
#define __NR_gettid SYS_gettid

static inline long syscall(long number, ...)
{
  if (number == SYS_gettid) {return gettid();}
  errno = ENOSYS;
  return -1;
}
#endif

#ifdef __cplusplus
}
#endif

#endif
