// Wait-free transfer of values from one thread to another; the reader gets the latest value.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace symplant::share {

/// Three slots: the writer owns one, the reader owns one, and one atomic exchange swaps the third with either of them.
/// Neither side waits, retries or allocates; a value that the reader did not fetch in time is overwritten.
///
/// One writer thread uses back(), back_index() and publish(), one reader thread update() and front(); both may be the
/// same thread. Memory order: publish() releases the contents of back(), update() acquires them. The exchange of each
/// side also acquires the slot that the other side released, so no slot is written while it is read.
template <class T>
class TripleBuffer {
 public:
  static constexpr std::size_t kSlots = 3;

  /// All slots start with copies of `value`; front() is valid from then on.
  explicit TripleBuffer(const T& value) : slots_{Slot{value}, Slot{value}, Slot{value}} {}
  TripleBuffer(const TripleBuffer&) = delete;
  TripleBuffer& operator=(const TripleBuffer&) = delete;

  /// Writer: the slot to fill. It holds an old value, not always the one published last.
  T& back() noexcept { return slots_[back_].value; }
  /// Writer: the index of back(), below kSlots, for a writer that tracks what each slot lacks.
  std::size_t back_index() const noexcept { return back_; }
  /// Writer: publishes back() and gets another slot.
  void publish() noexcept {
    const auto full = static_cast<std::uint8_t>(back_ | kFresh);
    back_ = middle_.exchange(full, std::memory_order_acq_rel) & kIndex;
  }

  /// Reader: gets the value published last; false if front() has it already.
  bool update() noexcept {
    // Relaxed is enough here: the exchange below orders the contents, and a stale read only delays the value.
    if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    return true;
  }
  /// Reader: the value of the last update(); unchanged until the next one.
  const T& front() const noexcept { return slots_[front_].value; }

 private:
  static constexpr std::uint8_t kIndex = 3;
  static constexpr std::uint8_t kFresh = 4;
  static constexpr std::size_t kCacheLine = 64;

  struct alignas(kCacheLine) Slot {
    T value;
  };

  std::array<Slot, kSlots> slots_;
  // In separate cache lines, so that the two threads do not contend for one.
  alignas(kCacheLine) std::atomic<std::uint8_t> middle_{1};
  alignas(kCacheLine) std::uint8_t back_ = 0;
  alignas(kCacheLine) std::uint8_t front_ = 2;

  static_assert(std::atomic<std::uint8_t>::is_always_lock_free);
};

}  // namespace symplant::share
