// Records what each instant changed and found: in the cycle, into memory that is there already.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "symplant/plant/plant.hpp"
#include "symplant/trace/record.hpp"

namespace symplant::trace {

/// An observer that fills a ring. One thread runs the plant, another one (or the same) drains; wait-free between them.
/// Of an instant its findings come first, in their order, then changes of symbols in the order of the symbol list,
/// then units. All of an instant is there to be drained, or nothing.
class Recorder final : public engine::Observer {
 public:
  /// Room for `capacity` records, rounded up to a power of two; what does not fit is counted as lost.
  Recorder(const tables::PlantTables& tables, std::size_t capacity);
  /// So many records loses nothing where the ring is drained after each instant.
  static std::size_t enough_for_an_instant(const tables::PlantTables& tables);

  /// The plant whose instants come; to be set before it is advanced.
  void attach(const plant::Plant& plant) { plant_ = &plant; }

  void instant(const engine::Instant& instant) noexcept override;
  void finding(const tables::Finding& finding) noexcept override;
  /// A finding of the host, between instants, by the thread that runs the plant.
  void raise(tables::Time time, tables::FindingKind kind, std::uint32_t of) noexcept;
  /// Between instants, by the thread that runs the plant. False where there was no room.
  bool note(tables::Time time, std::uint32_t of, std::uint64_t value) noexcept;

  /// Hands every record made so far to `take(const Record&)`.
  template <class Take>
  void drain(Take take) {
    const std::size_t end = written_.load(std::memory_order_acquire);
    std::size_t at = read_.load(std::memory_order_relaxed);
    for (; at != end; ++at) take(ring_[at & mask_]);
    read_.store(at, std::memory_order_release);
  }

  std::uint64_t lost_changes() const noexcept { return lost_changes_.load(std::memory_order_relaxed); }
  std::uint64_t lost_findings() const noexcept { return lost_findings_.load(std::memory_order_relaxed); }

 private:
  void note_bits(const engine::WordChange& change, const std::vector<std::uint32_t>& symbol_of_bit) noexcept;
  void record_symbols(const engine::Instant& instant) noexcept;
  void record_units(const engine::Instant& instant) noexcept;
  bool put(const Record& record) noexcept;
  void publish() noexcept;

  const tables::PlantTables& tables_;
  const plant::Plant* plant_ = nullptr;
  std::vector<std::uint32_t> symbol_of_operation_;  ///< bit -> symbol, or tables::kNoUnit for a bit that none has
  std::vector<std::uint32_t> symbol_of_event_;
  std::vector<std::uint32_t> symbol_of_operation_slot_;
  std::vector<std::uint32_t> symbol_of_event_slot_;
  std::vector<std::uint32_t> changed_;  ///< of the instant at hand; never grows beyond its first capacity
  std::size_t changed_count_ = 0;
  std::vector<std::uint32_t> units_;  ///< as last recorded: pack_unit
  std::vector<Record> ring_;
  std::size_t mask_;
  std::size_t at_ = 0;   ///< where the next record goes; behind written_ while an instant is recorded
  std::size_t end_ = 0;  ///< up to here there is room, as last seen
  std::atomic<std::size_t> written_{0};
  std::atomic<std::size_t> read_{0};
  std::atomic<std::uint64_t> lost_changes_{0};
  std::atomic<std::uint64_t> lost_findings_{0};
};

}  // namespace symplant::trace
