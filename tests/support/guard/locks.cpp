// Locks and waiting, interposed: noted where the thread is guarded, then done by glibc's own.
#include <dlfcn.h>
#include <pthread.h>
#include <semaphore.h>
#include <time.h>

#include "support/guard/record.hpp"

namespace {

using symplant::test::Violation;

/// The function that `name` would have been without us. Looked up once, at the start of the program or on first use.
template <class Function>
class Next {
 public:
  explicit constexpr Next(const char* name) noexcept : name_(name) {}

  void find() noexcept {
    if (function_ == nullptr) function_ = reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name_));
  }
  template <class... Arguments>
  int operator()(const void* caller, Arguments... arguments) {
    symplant::test::guard::note(Violation::Kind::lock, name_, caller);
    find();
    return function_(arguments...);
  }

 private:
  const char* name_;
  Function* function_ = nullptr;
};

constinit Next<int(pthread_mutex_t*)> mutex_lock("pthread_mutex_lock");
constinit Next<int(pthread_mutex_t*)> mutex_trylock("pthread_mutex_trylock");
constinit Next<int(pthread_mutex_t*, const timespec*)> mutex_timedlock("pthread_mutex_timedlock");
constinit Next<int(pthread_mutex_t*, clockid_t, const timespec*)> mutex_clocklock("pthread_mutex_clocklock");
constinit Next<int(pthread_rwlock_t*)> rwlock_rdlock("pthread_rwlock_rdlock");
constinit Next<int(pthread_rwlock_t*)> rwlock_wrlock("pthread_rwlock_wrlock");
constinit Next<int(pthread_rwlock_t*)> rwlock_tryrdlock("pthread_rwlock_tryrdlock");
constinit Next<int(pthread_rwlock_t*)> rwlock_trywrlock("pthread_rwlock_trywrlock");
constinit Next<int(pthread_spinlock_t*)> spin_lock("pthread_spin_lock");
constinit Next<int(pthread_spinlock_t*)> spin_trylock("pthread_spin_trylock");
constinit Next<int(pthread_cond_t*, pthread_mutex_t*)> cond_wait("pthread_cond_wait");
constinit Next<int(pthread_cond_t*, pthread_mutex_t*, const timespec*)> cond_timedwait("pthread_cond_timedwait");
constinit Next<int(sem_t*)> semaphore_wait("sem_wait");
constinit Next<int(sem_t*)> semaphore_trywait("sem_trywait");

/// So that the look-up is no part of what is guarded.
[[gnu::constructor]] void find_all() noexcept {
  mutex_lock.find();
  mutex_trylock.find();
  mutex_timedlock.find();
  mutex_clocklock.find();
  rwlock_rdlock.find();
  rwlock_wrlock.find();
  rwlock_tryrdlock.find();
  rwlock_trywrlock.find();
  spin_lock.find();
  spin_trylock.find();
  cond_wait.find();
  cond_timedwait.find();
  semaphore_wait.find();
  semaphore_trywait.find();
}

}  // namespace

extern "C" {

int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept { return mutex_lock(__builtin_return_address(0), mutex); }
int pthread_mutex_trylock(pthread_mutex_t* mutex) noexcept { return mutex_trylock(__builtin_return_address(0), mutex); }
int pthread_mutex_timedlock(pthread_mutex_t* mutex, const timespec* time) noexcept {
  return mutex_timedlock(__builtin_return_address(0), mutex, time);
}
int pthread_mutex_clocklock(pthread_mutex_t* mutex, clockid_t clock, const timespec* time) noexcept {
  return mutex_clocklock(__builtin_return_address(0), mutex, clock, time);
}
int pthread_rwlock_rdlock(pthread_rwlock_t* lock) noexcept { return rwlock_rdlock(__builtin_return_address(0), lock); }
int pthread_rwlock_wrlock(pthread_rwlock_t* lock) noexcept { return rwlock_wrlock(__builtin_return_address(0), lock); }
int pthread_rwlock_tryrdlock(pthread_rwlock_t* lock) noexcept {
  return rwlock_tryrdlock(__builtin_return_address(0), lock);
}
int pthread_rwlock_trywrlock(pthread_rwlock_t* lock) noexcept {
  return rwlock_trywrlock(__builtin_return_address(0), lock);
}
int pthread_spin_lock(pthread_spinlock_t* lock) noexcept { return spin_lock(__builtin_return_address(0), lock); }
int pthread_spin_trylock(pthread_spinlock_t* lock) noexcept { return spin_trylock(__builtin_return_address(0), lock); }
int pthread_cond_wait(pthread_cond_t* condition, pthread_mutex_t* mutex) {
  return cond_wait(__builtin_return_address(0), condition, mutex);
}
int pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex, const timespec* time) {
  return cond_timedwait(__builtin_return_address(0), condition, mutex, time);
}
int sem_wait(sem_t* semaphore) { return semaphore_wait(__builtin_return_address(0), semaphore); }
int sem_trywait(sem_t* semaphore) noexcept { return semaphore_trywait(__builtin_return_address(0), semaphore); }

}  // extern "C"
