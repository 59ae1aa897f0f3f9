// Wait-free transfer of values in their order from one thread to another.
#pragma once

#include <atomic>
#include <bit>
#include <cstddef>
#include <vector>

namespace symplant::share {

/// A queue of fixed capacity. Only the constructor allocates; neither side waits or retries.
///
/// One writer thread uses put(), one reader thread front() and pop(). put() releases the value, front() acquires it.
template <class T>
class Ring {
 public:
  /// Holds at least `capacity` values.
  explicit Ring(std::size_t capacity) : slots_(std::bit_ceil(capacity)) {}
  Ring(const Ring&) = delete;
  Ring& operator=(const Ring&) = delete;

  /// Writer: false, without an effect, if the ring is full. O(1).
  bool put(const T& value) noexcept {
    const std::size_t at = written_.load(std::memory_order_relaxed);
    if (at - read_.load(std::memory_order_acquire) == slots_.size()) return false;
    slots_[at & (slots_.size() - 1)] = value;
    written_.store(at + 1, std::memory_order_release);
    return true;
  }

  /// Reader: the oldest value, valid until pop(); null if the ring is empty. O(1).
  const T* front() const noexcept {
    const std::size_t at = read_.load(std::memory_order_relaxed);
    return at == written_.load(std::memory_order_acquire) ? nullptr : &slots_[at & (slots_.size() - 1)];
  }
  /// Reader: removes front().
  void pop() noexcept { read_.store(read_.load(std::memory_order_relaxed) + 1, std::memory_order_release); }

 private:
  static constexpr std::size_t kCacheLine = 64;

  std::vector<T> slots_;
  // In separate cache lines, so that the two threads do not contend for one.
  alignas(kCacheLine) std::atomic<std::size_t> written_{0};
  alignas(kCacheLine) std::atomic<std::size_t> read_{0};
};

}  // namespace symplant::share
