// A time of day that jumps an hour and a day back and forth at every read, for LD_PRELOAD. Other clocks do not
// change.
#include <dlfcn.h>
#include <sys/time.h>

#include <atomic>
#include <cstdint>
#include <ctime>

namespace {

constexpr std::time_t kJumps[] = {0, 3600, -3600, 86'400, -86'400};

std::time_t jump() noexcept {
  static std::atomic<unsigned> looks{0};
  return kJumps[looks.fetch_add(1, std::memory_order_relaxed) % 5];
}

using Look = int (*)(clockid_t, timespec*);

}  // namespace

extern "C" int clock_gettime(clockid_t clock, timespec* time) {
  static const auto next = reinterpret_cast<Look>(dlsym(RTLD_NEXT, "clock_gettime"));
  const int result = next(clock, time);
  if (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE) time->tv_sec += jump();
  return result;
}

extern "C" int gettimeofday(timeval* time, void*) {
  timespec now{};
  const int result = clock_gettime(CLOCK_REALTIME, &now);
  time->tv_sec = now.tv_sec;
  time->tv_usec = now.tv_nsec / 1000;
  return result;
}

extern "C" std::time_t time(std::time_t* to) {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  if (to != nullptr) *to = now.tv_sec;
  return now.tv_sec;
}
