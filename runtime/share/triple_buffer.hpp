// Wait-free hand-over of whole values from one thread to another: the latest wins.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace symplant::share {

/// Three slots: the writer owns one, the reader owns one, the third lies between them and changes hands by one atomic
/// exchange. Neither side waits, repeats or allocates; a value that the reader did not fetch in time is overwritten.
///
/// One writer thread uses back(), back_index() and publish(), one reader thread update() and front(); they may be the
/// same thread. Memory order: publish() releases what was written to back(), update() acquires it; the exchange of
/// either side also acquires the slot that the other one gave up, so that no slot is written while it is read.
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
  /// Writer: which slot back() is, below kSlots, for a writer that remembers what each slot lacks.
  std::size_t back_index() const noexcept { return back_; }
  /// Writer: hands back() over and takes another slot.
  void publish() noexcept {
    const auto full = static_cast<std::uint8_t>(back_ | kFresh);
    back_ = middle_.exchange(full, std::memory_order_acq_rel) & kIndex;
  }

  /// Reader: takes the value published last; false where there is none that front() has not shown yet.
  bool update() noexcept {
    // Relaxed is enough to look: the exchange below orders the contents, and a stale look only delays the value.
    if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    return true;
  }
  /// Reader: the value taken last; it stays as it is until the next update().
  const T& front() const noexcept { return slots_[front_].value; }

 private:
  static constexpr std::uint8_t kIndex = 3;
  static constexpr std::uint8_t kFresh = 4;
  static constexpr std::size_t kCacheLine = 64;

  struct alignas(kCacheLine) Slot {
    T value;
  };

  std::array<Slot, kSlots> slots_;
  // Apart, so that the two threads do not fight for one cache line.
  alignas(kCacheLine) std::atomic<std::uint8_t> middle_{1};
  alignas(kCacheLine) std::uint8_t back_ = 0;
  alignas(kCacheLine) std::uint8_t front_ = 2;

  static_assert(std::atomic<std::uint8_t>::is_always_lock_free);
};

}  // namespace symplant::share
