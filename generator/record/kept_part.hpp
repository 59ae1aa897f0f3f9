// What was read last, before a recording starts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "record/line.hpp"

namespace symplant::record {

/// Keeps the changes of the latest time, and the values at its beginning. Memory: 24 bytes a change, at most kMost of
/// them (24 MB), and 8 bytes a symbol. Not thread-safe.
class KeptPart {
 public:
  static constexpr std::size_t kMost = 1'000'000;

  /// `length`: how much is kept, ns; 0: only the values now.
  KeptPart(std::size_t symbols, Time length, std::size_t most = kMost);

  /// Adds the lines of an image, gaps included, by time. `now`: the time of the image.
  void add(const std::vector<Line>& lines, Time now);

  /// When the kept time begins: at the first image, or `length` before the latest one.
  Time begin() const { return begin_; }
  /// Whether there were more than `most` changes, so that less than `length` is kept.
  bool is_shortened() const { return shortened_; }
  /// By symbol: the value at the beginning; valid if is_known().
  std::uint64_t value(std::uint32_t symbol) const { return values_[symbol]; }
  bool is_known(std::uint32_t symbol) const { return known_[symbol]; }
  /// The end of a gap that began before begin(); not above begin(): no gap did.
  Time gap_end() const { return gap_end_; }
  /// What came after the beginning, by time.
  const std::deque<Line>& lines() const { return lines_; }

 private:
  void drop_first();

  Time length_;
  std::size_t most_;
  Time begin_ = -1;  ///< -1: there was no image
  Time gap_end_ = -1;
  bool shortened_ = false;
  std::vector<std::uint64_t> values_;
  std::vector<bool> known_;
  std::deque<Line> lines_;
};

}  // namespace symplant::record
