// Functions for priorities, processors and locked memory. Threads take turns here on one processor
// and have equal priority, so the results are those of an unprivileged user on Linux.
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <time.h>

#include <cerrno>
#include <cstring>

namespace
{

int fail(int error)
{
  errno = error;
  return -1;
}

/// Add the only processor to `set`.
int one_processor(size_t size, cpu_set_t * set)
{
  if (size == 0) {return EINVAL;}
  std::memset(set, 0, size);
  CPU_SET_S(0, size, set);
  return 0;
}

}  // namespace

extern "C" {

int sched_getscheduler(pid_t) {return SCHED_OTHER;}

int sched_setscheduler(pid_t, int policy, const sched_param *)
{
  return policy == SCHED_OTHER ? 0 : fail(EPERM);
}

int sched_getparam(pid_t, sched_param * parameters)
{
  *parameters = {};
  return 0;
}

int sched_setparam(pid_t, const sched_param * parameters)
{
  return parameters->sched_priority == 0 ? 0 : fail(EPERM);
}

int sched_rr_get_interval(pid_t, timespec *) {return fail(ENOSYS);}

int sched_getaffinity(pid_t, size_t size, cpu_set_t * set)
{
  const int error = one_processor(size, set);
  return error ? fail(error) : 0;
}

/// CPU_COUNT.
int __sched_cpucount(size_t size, const cpu_set_t * set)
{
  int count = 0;
  for (size_t i = 0; i < size; ++i) {
    count += __builtin_popcount(reinterpret_cast<const unsigned char *>(set)[i]);
  }
  return count;
}

int sched_setaffinity(pid_t, size_t, const cpu_set_t *) {return fail(EPERM);}

int getpriority(int, id_t) {return 0;}

int setpriority(int, id_t, int priority) {return priority == 0 ? 0 : fail(EPERM);}

int mlock(const void *, size_t) {return fail(EPERM);}

int mlockall(int) {return fail(EPERM);}

/// Nothing is locked.
int munlock(const void *, size_t) {return 0;}

int munlockall(void) {return 0;}

int prctl(int, ...) {return fail(EINVAL);}

int sched_get_priority_min(int policy) {return policy == SCHED_OTHER ? 0 : 1;}

int sched_get_priority_max(int policy) {return policy == SCHED_OTHER ? 0 : 99;}

int pthread_getschedparam(pthread_t, int * policy, sched_param * parameters)
{
  *policy = SCHED_OTHER;
  *parameters = {};
  return 0;
}

int pthread_setschedparam(pthread_t, int policy, const sched_param *)
{
  return policy == SCHED_OTHER ? 0 : EPERM;
}

int pthread_setschedprio(pthread_t, int priority) {return priority == 0 ? 0 : EPERM;}

int pthread_getaffinity_np(pthread_t, size_t size, cpu_set_t * set)
{
  return one_processor(size, set);
}

int pthread_setaffinity_np(pthread_t, size_t, const cpu_set_t *) {return EPERM;}

/// On Linux, the error comes later, from pthread_create().
int pthread_attr_setschedpolicy(pthread_attr_t *, int policy)
{
  return policy == SCHED_OTHER ? 0 : EPERM;
}

int pthread_attr_setinheritsched(pthread_attr_t *, int) {return 0;}

int pthread_attr_setscope(pthread_attr_t *, int scope)
{
  return scope == PTHREAD_SCOPE_SYSTEM ? 0 : ENOTSUP;
}

int pthread_getattr_default_np(pthread_attr_t * attributes) {return pthread_attr_init(attributes);}

/// All threads have stacks of the same size, whatever their attributes ask for.
int pthread_setattr_default_np(const pthread_attr_t *) {return 0;}

/// Names of threads are not shown anywhere, but the limit is that of Linux.
int pthread_setname_np(pthread_t, const char * name) {return std::strlen(name) > 15 ? ERANGE : 0;}

/// The CPU clock of a thread also counts the time of other threads.
int pthread_getcpuclockid(pthread_t, clockid_t * clock)
{
  *clock = CLOCK_MONOTONIC;
  return 0;
}

}
