// Tests of the guard: it catches and names each planted fault.
#include <fcntl.h>
#include <pthread.h>
#include <sched.h>
#include <semaphore.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <memory>
#include <mutex>
#include <shared_mutex>
#include <string>
#include <thread>
#include <vector>

#include "rt/expect_nothing.hpp"

namespace symplant::test {
namespace {

using exec::Guard;
using exec::kMostViolations;
using exec::Violation;
using exec::words;

/// The first fault of the work, without its caller.
std::string first_of(const std::function<void()>& work) {
  const GuardReport report = run_guarded(work);
  if (report.violations.empty()) return "nothing";
  const std::string text = words(report.violations.front());
  return text.substr(0, text.find(','));
}

/// For a call that only the trap sees; the expected name if there is no trap.
std::string trapped(const std::string& expected, const std::function<void()>& work) {
  const GuardReport report = run_guarded(work);
  if (!report.no_trap.empty()) {
    expect_trap(report);
    return expected;
  }
  for (const Violation& violation : report.violations) {
    if (violation.kind == Violation::Kind::system_call) return words(violation).substr(0, words(violation).find(','));
  }
  return "nothing";
}

/// Keeps the compiler from removing an unused allocation.
void use(void* memory) { asm volatile("" : : "r"(memory) : "memory"); }

TEST_CASE("Work that only computes is clean, and completes") {
  std::vector<int> numbers(1000, 3);
  int sum = 0;
  const GuardReport report = run_guarded([&] {
    for (int& number : numbers) sum += number *= 2;
    std::sort(numbers.begin(), numbers.end());
  });
  CHECK(sum == 6000);
  expect_nothing(report);
}

TEST_CASE("A use of the heap is reported with the name of its function") {
  void* kept = std::malloc(8);
  CHECK(first_of([] { use(std::malloc(16)); }) == "heap: malloc");
  CHECK(first_of([] { use(std::calloc(2, 16)); }) == "heap: calloc");
  CHECK(first_of([&] { use(kept = std::realloc(kept, 4096)); }) == "heap: realloc");
  CHECK(first_of([&] { std::free(kept); }) == "heap: free");
  CHECK(first_of([] { use(std::aligned_alloc(64, 64)); }) == "heap: aligned_alloc");
  CHECK(first_of([] {
          void* memory = nullptr;
          if (posix_memalign(&memory, 64, 64) == 0) use(memory);
        }) == "heap: posix_memalign");
}

TEST_CASE("New and delete are reported, also for arrays, aligned types and inside the standard library") {
  struct alignas(128) Wide {
    char bytes[128];
  };
  int* kept = new int(1);
  CHECK(first_of([] { use(new int(7)); }) == "heap: operator new");
  CHECK(first_of([] { use(new int[7]); }) == "heap: operator new");
  CHECK(first_of([] { use(new (std::nothrow) int(7)); }) == "heap: operator new");
  CHECK(first_of([] { use(new Wide); }) == "heap: operator new");
  CHECK(first_of([&] { delete kept; }) == "heap: operator delete");
  CHECK(first_of([] {
          std::string text(100, 'x');
          use(text.data());
        }) == "heap: operator new");
  CHECK(first_of([] { use(std::make_shared<int>(7).get()); }) == "heap: operator new");
}

TEST_CASE("An uncontended lock is reported") {
  std::mutex mutex;
  std::timed_mutex timed;
  std::shared_mutex shared;
  std::shared_timed_mutex both;
  CHECK(first_of([&] { const std::lock_guard lock(mutex); }) == "lock: pthread_mutex_lock");
  CHECK(first_of([&] {
          if (mutex.try_lock()) mutex.unlock();
        }) == "lock: pthread_mutex_trylock");
  CHECK(first_of([&] {
          if (timed.try_lock_for(std::chrono::milliseconds(1))) timed.unlock();
        }) == "lock: pthread_mutex_clocklock");
  CHECK(first_of([&] { const std::lock_guard lock(shared); }) == "lock: pthread_rwlock_wrlock");
  CHECK(first_of([&] { const std::shared_lock lock(shared); }) == "lock: pthread_rwlock_rdlock");
  CHECK(first_of([&] {
          if (both.try_lock_for(std::chrono::milliseconds(1))) both.unlock();
        }) == "lock: pthread_rwlock_clockwrlock");
  CHECK(first_of([&] {
          if (both.try_lock_shared_for(std::chrono::milliseconds(1))) both.unlock_shared();
        }) == "lock: pthread_rwlock_clockrdlock");
  const auto then = std::chrono::system_clock::now();
  CHECK(first_of([&] {
          if (both.try_lock_until(then)) both.unlock();
        }) == "lock: pthread_rwlock_timedwrlock");
  CHECK(first_of([&] {
          if (both.try_lock_shared_until(then)) both.unlock_shared();
        }) == "lock: pthread_rwlock_timedrdlock");
}

TEST_CASE("Spinning on a lock and waiting for a signal are reported") {
  pthread_spinlock_t spin{};
  pthread_spin_init(&spin, PTHREAD_PROCESS_PRIVATE);
  CHECK(first_of([&] {
          pthread_spin_lock(&spin);
          pthread_spin_unlock(&spin);
        }) == "lock: pthread_spin_lock");
  pthread_spin_destroy(&spin);
  sem_t semaphore{};
  sem_init(&semaphore, 0, 1);
  CHECK(first_of([&] { sem_wait(&semaphore); }) == "lock: sem_wait");
  const timespec past{};
  CHECK(first_of([&] { sem_timedwait(&semaphore, &past); }) == "lock: sem_timedwait");
  CHECK(first_of([&] { sem_clockwait(&semaphore, CLOCK_MONOTONIC, &past); }) == "lock: sem_clockwait");
  sem_destroy(&semaphore);
  pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
  pthread_cond_t condition = PTHREAD_COND_INITIALIZER;
  pthread_mutex_lock(&mutex);
  CHECK(first_of([&] { pthread_cond_timedwait(&condition, &mutex, &past); }) == "lock: pthread_cond_timedwait");
  CHECK(first_of([&] { pthread_cond_clockwait(&condition, &mutex, CLOCK_MONOTONIC, &past); }) ==
        "lock: pthread_cond_clockwait");
  pthread_barrier_t barrier{};
  pthread_barrier_init(&barrier, nullptr, 1);
  CHECK(first_of([&] { pthread_barrier_wait(&barrier); }) == "lock: pthread_barrier_wait");
  pthread_barrier_destroy(&barrier);
}

TEST_CASE("A write is reported and still executed") {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  CHECK(trapped("system call: write", [&] {
          if (::write(ends[1], "x", 1) != 1) std::abort();
        }) == "system call: write");
  char read_back = 0;
  CHECK(::read(ends[0], &read_back, 1) == 1);
  CHECK(read_back == 'x');
  close(ends[0]);
  close(ends[1]);
}

TEST_CASE("Reading the kernel's time, sleeping and yielding are reported") {
  CHECK(trapped("system call: clock_gettime", [] {
          timespec now{};
          syscall(SYS_clock_gettime, CLOCK_MONOTONIC, &now);
        }) == "system call: clock_gettime");
  CHECK(trapped("system call: nanosleep", [] {
          const timespec time{0, 1000};
          syscall(SYS_nanosleep, &time, nullptr);
        }) == "system call: nanosleep");
  CHECK(trapped("system call: clock_nanosleep", [] {
          const timespec time{0, 1000};
          clock_nanosleep(CLOCK_MONOTONIC, 0, &time, nullptr);
        }) == "system call: clock_nanosleep");
  CHECK(trapped("system call: sched_yield", [] { sched_yield(); }) == "system call: sched_yield");
}

TEST_CASE("Waiting on an atomic is reported by its system call") {
  std::atomic<int> waited{0};
  CHECK(trapped("system call: futex", [&] {
          const timespec time{0, 1000};
          syscall(SYS_futex, &waited, 0 /* FUTEX_WAIT */, 0, &time, nullptr, 0);
        }) == "system call: futex");
}

TEST_CASE("A call fails in the guard as it fails outside") {
  CHECK(trapped("system call: close", [] {
          if (close(-1) != -1 || errno != EBADF) std::abort();
        }) == "system call: close");
}

TEST_CASE("All faults are counted, and the first ones are stored in order") {
  const GuardReport report = run_guarded([] {
    for (int i = 0; i < 100; ++i) {
      void* memory = std::malloc(8);
      use(memory);
      std::free(memory);
    }
  });
  CHECK(report.count == 200);
  REQUIRE(report.violations.size() == kMostViolations);
  CHECK(words(report.violations[0]).starts_with("heap: malloc"));
  CHECK(words(report.violations[1]).starts_with("heap: free"));
  CHECK(report.text().ends_with("and 136 more\n"));
}

TEST_CASE("A thread under the trap may do anything while it is not guarded, repeatedly") {
  const GuardReport report = exec::run_watched([&] {
    for (int i = 0; i < 10; ++i) {
      {
        const Guard guard;
        if (i == 7) use(std::malloc(8));
      }
      const std::string text(100, 'x');  // between two cycles
      const timespec time{0, 1000};
      clock_nanosleep(CLOCK_MONOTONIC, 0, &time, nullptr);
    }
  });
  REQUIRE(report.count == 1);
  CHECK(words(report.violations[0]).starts_with("heap: malloc"));
  expect_trap(report);
}

TEST_CASE("Other threads are not restricted while one thread is guarded") {
  std::atomic<bool> inside{false};
  std::atomic<bool> done{false};
  std::thread other([&] {
    while (!inside) std::this_thread::yield();
    use(new int(7));
    done = true;
  });
  const GuardReport report = run_guarded([&] {
    inside = true;
    while (!done) {
    }
  });
  other.join();
  expect_nothing(report);
}

}  // namespace
}  // namespace symplant::test
