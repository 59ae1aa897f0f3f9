// Which bits of the events the clients of a server have read, and with which value.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "symplant/link/image/read_ranges.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link::image {

/// From the thread of the server to that of the cycle; wait-free. A read costs one step for each 64 positions.
class EventReads {
 public:
  explicit EventReads(std::uint32_t positions);

  // --- the server's thread

  /// A request begins: before its image is taken.
  void begin() noexcept { begun_.fetch_add(1); }
  /// The request has read these positions, at least one, of `image`.
  void read(std::span<const std::uint64_t> image, std::uint32_t first, std::uint32_t count) noexcept;
  /// The request is over: what it read is noted.
  void end() noexcept { ended_.store(begun_.load(std::memory_order_relaxed), std::memory_order_release); }

  // --- the cycle's thread

  /// The time of this cycle, by which the times between reads are measured.
  void set_time(tables::Time now) noexcept { now_.store(now, std::memory_order_relaxed); }
  /// The number of requests begun so far. After an image is published, these may still use the one before.
  std::uint64_t begun() const noexcept { return begun_.load(); }
  /// Whether everything that the first `requests` requests have read is noted.
  bool is_noted(std::uint64_t requests) const noexcept { return ended_.load(std::memory_order_acquire) >= requests; }
  /// A value begins: in the image that is published next, these bits of a word have the value `on`. was_read() ignores
  /// earlier reads of this value.
  void begin_value(std::uint32_t word, std::uint64_t bits, bool on) noexcept {
    read_[on ? 1 : 0][word].fetch_and(~bits, std::memory_order_relaxed);
  }
  /// Whether a noted request has read a position with the value `on` since its begin_value().
  bool was_read(std::uint32_t position, bool on) const noexcept;
  /// The mean time between reads of a position; -1 if it is not read again and again.
  tables::Time every(std::uint32_t position) const noexcept {
    return ranges_.every(position, now_.load(std::memory_order_relaxed));
  }

 private:
  using Words = std::vector<std::atomic<std::uint64_t>>;
  static constexpr std::size_t kCacheLine = 64;

  std::array<Words, 2> read_;  ///< positions that were read off, and those that were read on
  ReadRanges ranges_;
  alignas(kCacheLine) std::atomic<std::uint64_t> begun_{0};
  std::atomic<std::uint64_t> ended_{0};
  alignas(kCacheLine) std::atomic<tables::Time> now_{0};
};

}  // namespace symplant::link::image
