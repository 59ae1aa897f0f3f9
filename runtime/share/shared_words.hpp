// Wait-free hand-over of an image of 64-bit words, at the cost of what changed in it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "symplant/share/triple_buffer.hpp"

namespace symplant::share {

/// A triple buffer whose writer keeps the image and says which words it changed. The reader sees whole images only:
/// the words of one publish() together. All memory is taken by the constructor.
///
/// One writer thread uses words(), touch() and publish(), one reader thread update() and latest().
// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding): a cache line of its own for each side
class SharedWords {
 public:
  /// Both sides start with `initial`.
  explicit SharedWords(const std::vector<std::uint64_t>& initial);

  /// Writer: the image to change; every word changed must be touched before publish().
  std::span<std::uint64_t> words() noexcept { return current_; }
  /// Writer: says that a word was changed. O(1).
  void touch(std::size_t word) noexcept;
  /// Writer: hands the image over. O(words touched in the last three calls).
  void publish() noexcept;

  /// Reader: takes the image published last; false where there is no newer one.
  bool update() noexcept { return slots_.update(); }
  /// Reader: the image taken last.
  std::span<const std::uint64_t> latest() const noexcept { return slots_.front(); }

 private:
  using Words = std::vector<std::uint64_t>;
  static constexpr std::size_t kSlots = TripleBuffer<Words>::kSlots;

  Words current_;
  TripleBuffer<Words> slots_;
  std::array<std::vector<std::size_t>, kSlots> missing_;  ///< a slot: words that changed since it was written last
  std::vector<std::uint8_t> missing_in_;                  ///< a word: bit s is on where missing_[s] names it
};

}  // namespace symplant::share
