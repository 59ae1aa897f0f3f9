// Work for several processors at once.
#include "base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace symplant::base {

namespace {

/// The calls that are left, which all threads take from.
class Calls {
 public:
  Calls(std::size_t count, const std::function<void(std::size_t)>& work) : count_(count), work_(work) {}

  /// Takes calls until none is left. An exception ends all threads.
  void take() noexcept {
    try {
      for (std::size_t next = next_++; next < count_; next = next_++) work_(next);
    } catch (...) {
      next_ = count_;
      const std::lock_guard lock(mutex_);
      fault_ = std::current_exception();
    }
  }

  void rethrow() const {
    if (fault_ != nullptr) std::rethrow_exception(fault_);
  }

 private:
  const std::size_t count_;
  const std::function<void(std::size_t)>& work_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::exception_ptr fault_;
};

}  // namespace

std::size_t threads_for(std::size_t rows) {
  constexpr std::size_t kFewRows = 20'000;
  constexpr std::size_t kMostThreads = 4;  // more would wait for memory
  if (rows < kFewRows) return 1;
  return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, kMostThreads);
}

void for_each_number(std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& work) {
  Calls calls(count, work);
  std::vector<std::jthread> others;
  try {
    for (std::size_t i = 1; i < std::min(threads, count); ++i) others.emplace_back([&calls] { calls.take(); });
  } catch (const std::system_error&) {
    // The system has no more threads: those that began, and this one, do all.
  }
  calls.take();
  others.clear();  // waits
  calls.rethrow();
}

}  // namespace symplant::base
