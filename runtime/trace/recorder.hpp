// Records what each instant changed: in the cycle, into memory that is there already.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "symplant/core/plant.hpp"

namespace symplant::trace {

/// One net change of a symbol.
struct Change {
  core::Time time;
  std::uint64_t value;   ///< 0 or 1; a value plane's content for a numeric symbol
  std::uint32_t symbol;  ///< its row in PlantTables::symbols
};

/// An observer that fills a ring. One thread runs the plant, another one (or the same) drains; wait-free between them.
/// Within an instant changes stand in the order of the symbol list.
class Recorder final : public core::Observer {
 public:
  /// Room for `capacity` changes, rounded up to a power of two; what does not fit is counted as lost.
  Recorder(const core::PlantTables& tables, std::size_t capacity);

  /// The plant whose instants come; to be set before it is advanced.
  void attach(const core::Plant& plant) { plant_ = &plant; }

  void instant(const core::Instant& instant) noexcept override;

  /// Hands every change recorded so far to `take(const Change&)`.
  template <class Take>
  void drain(Take take) {
    const std::size_t end = written_.load(std::memory_order_acquire);
    std::size_t at = read_.load(std::memory_order_relaxed);
    for (; at != end; ++at) take(ring_[at & mask_]);
    read_.store(at, std::memory_order_release);
  }

  std::uint64_t lost() const noexcept { return lost_.load(std::memory_order_relaxed); }

 private:
  void note_bits(const core::WordChange& change, const std::vector<std::uint32_t>& symbol_of_bit) noexcept;

  const core::PlantTables& tables_;
  const core::Plant* plant_ = nullptr;
  std::vector<std::uint32_t> symbol_of_operation_;  ///< bit -> symbol, or core::kNoUnit for a bit that none has
  std::vector<std::uint32_t> symbol_of_event_;
  std::vector<std::uint32_t> symbol_of_operation_slot_;
  std::vector<std::uint32_t> symbol_of_event_slot_;
  std::vector<std::uint32_t> changed_;  ///< of the instant at hand; never grows beyond its first capacity
  std::size_t changed_count_ = 0;
  std::vector<Change> ring_;
  std::size_t mask_;
  std::atomic<std::size_t> written_{0};
  std::atomic<std::size_t> read_{0};
  std::atomic<std::uint64_t> lost_{0};
};

}  // namespace symplant::trace
