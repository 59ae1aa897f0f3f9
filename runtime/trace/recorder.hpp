// Records the changes and findings of each instant in the cycle, without allocation.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "symplant/plant/plant.hpp"
#include "symplant/trace/record.hpp"
#include "symplant/trace/zeroed_array.hpp"

namespace symplant::trace {

/// An observer that fills a ring. One thread runs the plant, another one (or the same) drains the ring; both are
/// wait-free. The records of an instant are its findings in their order, then changes of symbols in list order, then
/// units, then parts, then malfunctions; parts in an instantaneous loop may come before all of them. They become
/// available to drain() together. A ring that is empty starts again at its first slot, so that it takes memory only for
/// the most records that it has held at once.
class Recorder final : public engine::Observer {
 public:
  /// What is recorded of parts that move.
  enum class Detail : std::uint8_t {
    changes,  ///< where they come and go
    motions,  ///< also the speeds of parts on tracks, for a picture that moves
  };

  /// Allocates `capacity` records, rounded up to a power of two. Records that do not fit are counted as lost.
  Recorder(const tables::PlantTables& tables, std::size_t capacity, Detail detail = Detail::changes);
  /// A capacity that loses nothing if the ring is drained after each instant, unless parts or malfunctions are in an
  /// instantaneous loop.
  static std::size_t enough_for_an_instant(const tables::PlantTables& tables, Detail detail = Detail::changes);
  /// The same, also with such a loop, up to 4 million records.
  static std::size_t enough_for_a_loop(const tables::PlantTables& tables, Detail detail = Detail::changes);

  /// Sets the observed plant; to be called before the plant advances.
  void attach(const plant::Plant& plant) { plant_ = &plant; }

  void instant(const engine::Instant& instant) noexcept override;
  void finding(const tables::Finding& finding) noexcept override;
  void parts_before(tables::Time time, std::span<const engine::PartChange> parts) noexcept override;
  /// Adds a finding of the host; `value` as in Record, for the kinds that have one. Only between instants, by the
  /// thread that runs the plant.
  void raise(tables::Time time, tables::FindingKind kind, std::uint32_t of, std::uint64_t value = 0) noexcept;
  /// To be called before a note about an act that takes effect in the next instant at `time`. If an instant at `time`
  /// was recorded already, it first adds a kInstantNote. Only between instants, by the thread that runs the plant.
  void begin_act(tables::Time time) noexcept;
  /// Adds a note about what is done to the plant (kActNote, kQualityNote), which counts as a change if it is lost.
  void act(tables::Time time, std::uint32_t of, std::uint64_t value) noexcept;
  /// The number of instants at `time` that the plant has reported so far, also those without a record; 0 if `time` is
  /// not that of the latest instant. Only for the thread that runs the plant.
  std::uint32_t instants_at(tables::Time time) const noexcept { return time == instant_time_ ? ordinal_ : 0; }
  /// Whether the ring has room for this number of notes now. Only for the thread that runs the plant.
  bool has_room(std::size_t notes) noexcept { return end_ - at_ >= notes || has_room_for(notes); }
  /// Treats the current states of units as recorded. To be called after a reset or a restore of the plant; a note must
  /// report that to the reader of the records. O(units).
  void take_over() noexcept;
  /// The current turn. Acts on the plant with equal turns take effect in one instant; next_turn() is for the code that
  /// advances the plant.
  std::uint32_t turn() const noexcept { return turn_; }
  void next_turn() noexcept { ++turn_; }
  /// The number of instants with records so far. Only for the thread that runs the plant.
  std::uint64_t instants() const noexcept { return instants_; }
  /// Adds a note. Only between instants, by the thread that runs the plant. False if the ring is full.
  bool note(tables::Time time, std::uint32_t of, std::uint64_t value) noexcept;

  /// Passes every available record to `take(const Record&)`.
  template <class Take>
  void drain(Take take) {
    const std::size_t end = written_.load(std::memory_order_acquire);
    std::size_t at = read_.load(std::memory_order_relaxed);
    for (; at != end; ++at) {
      if (at == skip_from_) at = skip_to_;
      take(ring_[at & mask_]);
    }
    read_.store(at, std::memory_order_release);
  }

  std::uint64_t lost_changes() const noexcept { return lost_changes_.load(std::memory_order_relaxed); }
  std::uint64_t lost_findings() const noexcept { return lost_findings_.load(std::memory_order_relaxed); }

 private:
  void note_bits(const engine::WordChange& change, const std::vector<std::uint32_t>& symbol_of_bit) noexcept;
  void record_symbols(const engine::Instant& instant) noexcept;
  void record_units(const engine::Instant& instant) noexcept;
  void record_tracks(const engine::Instant& instant) noexcept;
  void record_parts(tables::Time time, std::span<const engine::PartChange> parts) noexcept;
  void record_malfunctions(const engine::Instant& instant) noexcept;
  void record_values(const engine::Instant& instant) noexcept;
  void expect_values() noexcept;
  void put_finding(const tables::Finding& finding, std::uint64_t value) noexcept;
  bool put(const Record& record) noexcept;
  bool has_room_for(std::size_t records) noexcept;
  void start_again() noexcept;
  bool publish() noexcept;
  void begin_instant(tables::Time time) noexcept;

  const tables::PlantTables& tables_;
  const plant::Plant* plant_ = nullptr;
  std::vector<std::uint32_t> symbol_of_operation_;  ///< bit -> symbol, or tables::kNone for an unused bit
  std::vector<std::uint32_t> symbol_of_event_;
  std::vector<std::uint32_t> symbol_of_operation_slot_;
  std::vector<std::uint32_t> symbol_of_event_slot_;
  ZeroedArray<std::uint32_t> changed_;  ///< symbols changed in this instant
  std::size_t changed_count_ = 0;
  std::vector<std::uint32_t> units_;    ///< as last recorded: pack_unit
  std::vector<tables::Time> traces_;    ///< by output of a value: how often a trace shows it; 0: never
  std::vector<std::uint64_t> outputs_;  ///< as last recorded
  std::vector<std::uint64_t> pending_;  ///< one bit per output that changed since
  Detail detail_;
  std::uint64_t instants_ = 0;
  tables::Time instant_time_ = -1;  ///< of the last instant
  std::uint32_t ordinal_ = 0;       ///< of it, among those of its time, from 1
  bool announced_ = false;          ///< the next instant at its time has its note
  std::uint32_t turn_ = 0;
  ZeroedArray<Record> ring_;
  std::size_t mask_;
  std::size_t at_ = 0;   ///< index of the next record; ahead of written_ while an instant is recorded
  std::size_t end_ = 0;  ///< end of the free room, as last read
  // The indexes from skip_from_ to skip_to_ hold no records. Written only while the ring is empty, read only while not.
  std::size_t skip_from_ = 0;
  std::size_t skip_to_ = 0;
  std::atomic<std::size_t> written_{0};
  std::atomic<std::size_t> read_{0};
  std::atomic<std::uint64_t> lost_changes_{0};
  std::atomic<std::uint64_t> lost_findings_{0};
};

}  // namespace symplant::trace
