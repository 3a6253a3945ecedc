/* The part of libcap with which programs ask for capabilities of the process. A page has none. */
#ifndef SYS__CAPABILITY_H_
#define SYS__CAPABILITY_H_

#include <errno.h>
#include <sys/types.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef int cap_value_t;
typedef struct _cap_struct * cap_t;
typedef enum {CAP_EFFECTIVE = 0, CAP_PERMITTED = 1, CAP_INHERITABLE = 2} cap_flag_t;
typedef enum {CAP_CLEAR = 0, CAP_SET = 1} cap_flag_value_t;

/* The numbers are those of Linux. */
#define CAP_DAC_OVERRIDE 1
#define CAP_KILL 5
#define CAP_SETGID 6
#define CAP_SETUID 7
#define CAP_NET_BIND_SERVICE 10
#define CAP_NET_ADMIN 12
#define CAP_NET_RAW 13
#define CAP_IPC_LOCK 14
#define CAP_SYS_RAWIO 17
#define CAP_SYS_PTRACE 19
#define CAP_SYS_ADMIN 21
#define CAP_SYS_NICE 23
#define CAP_SYS_RESOURCE 24
#define CAP_SYS_TIME 25

static inline cap_t cap_get_proc(void)
{
  static int none;
  return (cap_t)&none;
}

static inline int cap_get_flag(
  cap_t capabilities, cap_value_t capability, cap_flag_t flag, cap_flag_value_t * value)
{
  (void)capabilities;
  (void)capability;
  (void)flag;
  *value = CAP_CLEAR;
  return 0;
}

static inline int cap_set_flag(
  cap_t capabilities, cap_flag_t flag, int count, const cap_value_t * list, cap_flag_value_t value)
{
  (void)capabilities;
  (void)flag;
  (void)count;
  (void)list;
  (void)value;
  return 0;
}

static inline int cap_set_proc(cap_t capabilities)
{
  (void)capabilities;
  errno = EPERM;
  return -1;
}

static inline int cap_free(void * object)
{
  (void)object;
  return 0;
}

#ifdef __cplusplus
}
#endif
#endif
