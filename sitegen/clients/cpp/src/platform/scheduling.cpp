// POSIX functions for thread priorities. Threads take turns here and have equal priority, so the
// results are those of an unprivileged user on Linux.
#include <pthread.h>
#include <sched.h>
#include <time.h>

#include <cerrno>

extern "C" {

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

int pthread_setaffinity_np(pthread_t, size_t, const cpu_set_t *) {return EPERM;}

/// The CPU clock of a thread also counts the time of other threads.
int pthread_getcpuclockid(pthread_t, clockid_t * clock)
{
  *clock = CLOCK_MONOTONIC;
  return 0;
}

}
