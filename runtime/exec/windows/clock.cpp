// Reads the performance counter, and sleeps by a timer of high resolution (Windows 10 1803).
#include "symplant/exec/clock.hpp"

#include <windows.h>

#include <algorithm>
#include <chrono>

#include "symplant/exec/guard/guard.hpp"

namespace symplant::exec {
namespace {

constexpr DWORD kHighResolution = 2;  // CREATE_WAITABLE_TIMER_HIGH_RESOLUTION
constexpr tables::Time kTick = 100;   // ns, of a timer

/// A timer of the calling thread.
class Timer {
 public:
  Timer() noexcept : handle_(CreateWaitableTimerExW(nullptr, nullptr, kHighResolution, TIMER_ALL_ACCESS)) {
    if (handle_ == nullptr) handle_ = CreateWaitableTimerExW(nullptr, nullptr, 0, TIMER_ALL_ACCESS);
  }
  ~Timer() { CloseHandle(handle_); }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

  void sleep(tables::Time time) const noexcept {
    LARGE_INTEGER due{};
    due.QuadPart = -std::max<tables::Time>(time / kTick, 1);  // below 0: from now on
    if (SetWaitableTimer(handle_, &due, 0, nullptr, nullptr, FALSE) != 0) WaitForSingleObject(handle_, INFINITE);
  }

 private:
  HANDLE handle_;
};

}  // namespace

tables::Time MonotonicClock::now() noexcept {
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(since).count();
}

void MonotonicClock::sleep_until(tables::Time time) noexcept {
  const Unguarded allowed;
  static thread_local const Timer timer;
  for (tables::Time left = time - now(); left > 0; left = time - now()) timer.sleep(left);
}

}  // namespace symplant::exec
