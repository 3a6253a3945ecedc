// The pthread functions that <thread>, <mutex>, <condition_variable> and <future> use. This C library
// has no threads, so the linker replaces its functions with these (cmake/engine.cmake).
#include <errno.h>
#include <pthread.h>
#include <sched.h>
#include <time.h>

#include <cstring>
#include <limits>

#include "rclcpp/detail/host.h"
#include "rclcpp/detail/platform.hpp"
#include "rclcpp/detail/stacks.hpp"

namespace rclcpp
{
namespace detail
{

namespace
{

/// Our contents of a pthread_mutex_t; all zeros, its initial value, is an unlocked mutex.
struct Mutex
{
  const void * owner;
  int count;
  int waiting;
  int type;
};
static_assert(sizeof(Mutex) <= sizeof(pthread_mutex_t));

/// Our contents of a pthread_cond_t.
struct Condition
{
  unsigned signals;
};
static_assert(sizeof(Condition) <= sizeof(pthread_cond_t));

Mutex & as_mutex(pthread_mutex_t * mutex) {return *reinterpret_cast<Mutex *>(mutex);}
Condition & as_condition(pthread_cond_t * condition)
{
  return *reinterpret_cast<Condition *>(condition);
}

const char kMain = 0;  // its address identifies the main thread

const void * self() {return current_thread ? static_cast<const void *>(current_thread) : &kMain;}

/// Convert a time of the system clock to that of now(); infinity if there is none. The system clock
/// has a resolution of a millisecond, so round up.
double deadline(const timespec * time)
{
  if (!time) {return std::numeric_limits<double>::infinity();}
  timespec system;
  clock_gettime(CLOCK_REALTIME, &system);
  return now() + 1 + static_cast<double>(time->tv_sec - system.tv_sec) * 1e3 +
         static_cast<double>(time->tv_nsec - system.tv_nsec) / 1e6;
}

/// Wait until anything happens or until `end`; false if that is past.
bool wait_until(double end)
{
  const double left = end - now();
  if (left <= 0) {return false;}
  wait(left == std::numeric_limits<double>::infinity() ? -1 : left);
  return true;
}

int lock(Mutex & mutex, const timespec * time)
{
  const void * me = self();
  if (mutex.owner == me) {
    if (mutex.type != PTHREAD_MUTEX_RECURSIVE) {return EDEADLK;}
    ++mutex.count;
    return 0;
  }
  const double end = deadline(time);
  while (mutex.owner) {
    ++mutex.waiting;
    const bool in_time = wait_until(end);
    --mutex.waiting;
    if (!in_time) {return ETIMEDOUT;}
  }
  mutex.owner = me;
  mutex.count = 1;
  return 0;
}

int unlock(Mutex & mutex)
{
  if (--mutex.count > 0) {return 0;}
  mutex.owner = nullptr;
  mutex.count = 0;
  if (mutex.waiting) {wake();}
  return 0;
}

int wait_at(Condition & condition, Mutex & mutex, const timespec * time)
{
  const double end = deadline(time);
  const unsigned signals = condition.signals;
  int result = 0;
  unlock(mutex);
  while (condition.signals == signals && !result) {
    if (!wait_until(end)) {result = ETIMEDOUT;}
  }
  lock(mutex, nullptr);
  return result;
}

int signal(Condition & condition)
{
  ++condition.signals;
  wake();  // also wakes executors that spin until a future is complete
  return 0;
}

using Destructor = void (*)(void *);

struct Keys
{
  std::vector<Destructor> destructors;
  std::vector<const void *> of_main;
};

Keys & keys()
{
  static auto * keys = new Keys;
  return *keys;
}

std::vector<const void *> & values()
{
  return current_thread ? current_thread->values : keys().of_main;
}

void destroy_values(Thread & thread)
{
  for (std::size_t key = 0; key < thread.values.size(); ++key) {
    const void * value = thread.values[key];
    thread.values[key] = nullptr;
    if (value && keys().destructors[key]) {keys().destructors[key](const_cast<void *>(value));}
  }
}

void body(Thread * thread)
{
  guarded([thread] {thread->result = thread->function(thread->argument);});
  destroy_values(*thread);
  thread->done = true;
  if (thread->detached) {delete thread;}
  wake();
}

}  // namespace

}  // namespace detail
}  // namespace rclcpp

extern "C" {

using rclcpp::detail::Thread;

int __wrap_pthread_create(
  pthread_t * thread, const pthread_attr_t *, void * (*function)(void *), void * argument)
{
  auto made = new Thread{function, argument};
  if (!rclcpp::detail::launch(rclcpp::detail::body, made)) {
    delete made;
    return EAGAIN;
  }
  *thread = reinterpret_cast<pthread_t>(made);
  return 0;
}

int __wrap_pthread_join(pthread_t thread, void ** result)
{
  auto joined = reinterpret_cast<Thread *>(thread);
  if (joined == rclcpp::detail::current_thread) {return EDEADLK;}
  while (!joined->done) {rclcpp::detail::wait(-1);}
  if (result) {*result = joined->result;}
  delete joined;
  return 0;
}

int __wrap_pthread_detach(pthread_t thread)
{
  auto detached = reinterpret_cast<Thread *>(thread);
  detached->detached = true;
  if (detached->done) {delete detached;}
  return 0;
}

pthread_t __wrap_pthread_self(void)
{
  return reinterpret_cast<pthread_t>(const_cast<void *>(rclcpp::detail::self()));
}

int __wrap_pthread_mutexattr_init(pthread_mutexattr_t * attributes)
{
  attributes->__attr = PTHREAD_MUTEX_NORMAL;
  return 0;
}

int __wrap_pthread_mutexattr_settype(pthread_mutexattr_t * attributes, int type)
{
  attributes->__attr = static_cast<unsigned>(type);
  return 0;
}

int __wrap_pthread_mutex_init(pthread_mutex_t * mutex, const pthread_mutexattr_t * attributes)
{
  std::memset(mutex, 0, sizeof(*mutex));
  rclcpp::detail::as_mutex(mutex).type = attributes ? static_cast<int>(attributes->__attr) : 0;
  return 0;
}

int __wrap_pthread_mutex_lock(pthread_mutex_t * mutex)
{
  return rclcpp::detail::lock(rclcpp::detail::as_mutex(mutex), nullptr);
}

int __wrap_pthread_mutex_timedlock(pthread_mutex_t * mutex, const timespec * end)
{
  return rclcpp::detail::lock(rclcpp::detail::as_mutex(mutex), end);
}

int __wrap_pthread_mutex_trylock(pthread_mutex_t * mutex)
{
  auto & tried = rclcpp::detail::as_mutex(mutex);
  const bool mine = tried.owner == rclcpp::detail::self();
  if (tried.owner && !(mine && tried.type == PTHREAD_MUTEX_RECURSIVE)) {return EBUSY;}
  return rclcpp::detail::lock(tried, nullptr);
}

int __wrap_pthread_mutex_unlock(pthread_mutex_t * mutex)
{
  return rclcpp::detail::unlock(rclcpp::detail::as_mutex(mutex));
}

int __wrap_pthread_cond_init(pthread_cond_t * condition, const pthread_condattr_t *)
{
  std::memset(condition, 0, sizeof(*condition));
  return 0;
}

int __wrap_pthread_cond_wait(pthread_cond_t * condition, pthread_mutex_t * mutex)
{
  return rclcpp::detail::wait_at(
    rclcpp::detail::as_condition(condition), rclcpp::detail::as_mutex(mutex), nullptr);
}

int __wrap_pthread_cond_timedwait(
  pthread_cond_t * condition, pthread_mutex_t * mutex, const timespec * end)
{
  return rclcpp::detail::wait_at(
    rclcpp::detail::as_condition(condition), rclcpp::detail::as_mutex(mutex), end);
}

// Spurious wake-ups are allowed: each thread checks its condition again.
int __wrap_pthread_cond_signal(pthread_cond_t * condition)
{
  return rclcpp::detail::signal(rclcpp::detail::as_condition(condition));
}

int __wrap_pthread_cond_broadcast(pthread_cond_t * condition)
{
  return rclcpp::detail::signal(rclcpp::detail::as_condition(condition));
}

int __wrap_pthread_key_create(pthread_key_t * key, void (*destructor)(void *))
{
  auto & destructors = rclcpp::detail::keys().destructors;
  *key = static_cast<pthread_key_t>(destructors.size());
  destructors.push_back(destructor);
  return 0;
}

int __wrap_pthread_key_delete(pthread_key_t key)
{
  rclcpp::detail::keys().destructors[key] = nullptr;
  return 0;
}

void * __wrap_pthread_getspecific(pthread_key_t key)
{
  const auto & values = rclcpp::detail::values();
  return key < values.size() ? const_cast<void *>(values[key]) : nullptr;
}

int __wrap_pthread_setspecific(pthread_key_t key, const void * value)
{
  auto & values = rclcpp::detail::values();
  if (values.size() <= key) {values.resize(key + 1);}
  values[key] = value;
  return 0;
}

}  // extern "C"
