// The engine's plant with its memory and a record of its reports, in the reference's words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "property/value_differences.hpp"
#include "support/reference/reference.hpp"
#include "symplant/plant/plant.hpp"

namespace symplant::property {

/// Maps a bit or slot to its symbol.
struct SymbolIndexes {
  explicit SymbolIndexes(const tables::PlantTables& tables);

  std::vector<std::uint32_t> operation_bits;
  std::vector<std::uint32_t> event_bits;
  std::vector<std::uint32_t> operation_slots;
  std::vector<std::uint32_t> event_slots;
};

class EnginePlant final : private engine::Observer {
 public:
  EnginePlant(const tables::PlantTables& tables, const std::vector<engine::Behaviour>& behaviours);

  plant::Plant& plant() { return *plant_; }
  const plant::Plant& plant() const { return *plant_; }

  void write(std::uint32_t symbol, std::uint64_t value);
  engine::Observer& observer() { return *this; }
  /// Without an observer the engine reports no instants, and may take other paths.
  void advance_to(tables::Time time, bool observed) { plant_->advance_to(time, observed ? this : nullptr); }
  void advance_before(tables::Time time, bool observed) { plant_->advance_before(time, observed ? this : nullptr); }

  std::uint64_t value(std::uint32_t symbol) const;  ///< effective

  /// Since forget().
  const std::vector<reference::InstantRecord>& instants() const { return instants_; }
  const std::vector<bool>& units_reported() const { return units_reported_; }
  /// The first invalid report; empty if all are valid.
  std::string fault() const;
  void forget();
  /// What the trace has of values. Not part of a save.
  ValueTrace& value_trace() { return value_trace_; }

 private:
  void instant(const engine::Instant& instant) noexcept override;
  void parts_before(tables::Time time, std::span<const engine::PartChange> parts) noexcept override;
  void finding(const tables::Finding& finding) noexcept override { pending_.push_back(finding); }
  void add_bits(reference::InstantRecord& record, std::span<const engine::WordChange> words, bool operations);
  void add_slots(reference::InstantRecord& record, std::span<const std::uint32_t> slots, bool operations);

  const tables::PlantTables& tables_;
  SymbolIndexes indexes_;
  std::vector<engine::Behaviour> behaviours_;
  std::unique_ptr<std::max_align_t[]> memory_;
  std::unique_ptr<plant::Plant> plant_;
  std::vector<reference::InstantRecord> instants_;
  std::vector<tables::Finding> pending_;  ///< reported before their instant
  std::vector<engine::PartChange> pending_parts_;
  std::vector<bool> units_reported_;
  std::string fault_;
  ValueTrace value_trace_;
  unsigned writes_ = 0;  ///< every third write uses whole words
};

}  // namespace symplant::property
