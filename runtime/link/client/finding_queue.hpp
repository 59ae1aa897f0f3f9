// Findings on their path from the thread of a link to the thread of the cycle.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <optional>

#include "symplant/link/link.hpp"

namespace symplant::link::client {

/// One thread puts, one takes; both are wait-free.
class FindingQueue {
 public:
  /// False if it is full.
  bool put(const LinkFinding& finding) noexcept {
    const std::size_t end = written_.load(std::memory_order_relaxed);
    if (end - read_.load(std::memory_order_acquire) == kRoom) return false;
    ring_[end % kRoom] = finding;
    written_.store(end + 1, std::memory_order_release);
    return true;
  }
  /// The oldest one; nothing if it is empty.
  std::optional<LinkFinding> take() noexcept {
    const std::size_t at = read_.load(std::memory_order_relaxed);
    if (at == written_.load(std::memory_order_acquire)) return std::nullopt;
    const LinkFinding finding = ring_[at % kRoom];
    read_.store(at + 1, std::memory_order_release);
    return finding;
  }

 private:
  static constexpr std::size_t kRoom = 64;

  std::array<LinkFinding, kRoom> ring_{};
  std::atomic<std::size_t> written_{0};
  std::atomic<std::size_t> read_{0};
};

}  // namespace symplant::link::client
