// Wait-free transfer of an image of 64-bit words between two threads; its cost depends on the changes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "symplant/share/triple_buffer.hpp"

namespace symplant::share {

/// A triple buffer whose writer keeps the image and marks the words that it changes. The reader always gets a complete
/// image of one publish(). Only the constructor allocates.
///
/// One writer thread uses words(), touch() and publish(), one reader thread update() and latest().
// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding): each side has a separate cache line
class SharedWords {
 public:
  /// Both sides start with `initial`.
  explicit SharedWords(const std::vector<std::uint64_t>& initial);

  /// Writer: the image to change; every word changed must be touched before publish().
  std::span<std::uint64_t> words() noexcept { return current_; }
  /// Writer: marks a word as changed. O(1).
  void touch(std::size_t word) noexcept;
  /// Writer: publishes the image. O(words touched since the third last call).
  void publish() noexcept;

  /// Reader: gets the image published last; false if there is no newer one.
  bool update() noexcept { return slots_.update(); }
  /// Reader: the image that update() got last.
  std::span<const std::uint64_t> latest() const noexcept { return slots_.front(); }

 private:
  using Words = std::vector<std::uint64_t>;
  static constexpr std::size_t kSlots = TripleBuffer<Words>::kSlots;

  Words current_;
  TripleBuffer<Words> slots_;
  std::array<std::vector<std::size_t>, kSlots> missing_;  ///< of each slot: words that changed since its last update
  std::vector<std::uint8_t> missing_in_;                  ///< of each word: bit s is set if missing_[s] lists it
};

}  // namespace symplant::share
