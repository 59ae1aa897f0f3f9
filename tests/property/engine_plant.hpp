// The engine's plant with its memory and a record of what it told, in the reference's words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "support/reference/reference.hpp"
#include "symplant/core/plant.hpp"

namespace symplant::property {

/// Which symbol stands at a bit or slot.
struct SymbolPlaces {
  explicit SymbolPlaces(const core::PlantTables& tables);

  std::vector<std::uint32_t> operation_bits;
  std::vector<std::uint32_t> event_bits;
  std::vector<std::uint32_t> operation_slots;
  std::vector<std::uint32_t> event_slots;
};

class EnginePlant final : private core::Observer {
 public:
  EnginePlant(const core::PlantTables& tables, const std::vector<core::Behaviour>& behaviours);

  core::Plant& plant() { return *plant_; }
  const core::Plant& plant() const { return *plant_; }

  void write(std::uint32_t symbol, std::uint64_t value);
  void advance_to(core::Time time) { plant_->advance_to(time, this); }
  void advance_before(core::Time time) { plant_->advance_before(time, this); }

  std::uint64_t value(std::uint32_t symbol) const;  ///< effective

  /// Since forget().
  const std::vector<reference::InstantRecord>& instants() const { return instants_; }
  const std::vector<bool>& units_told() const { return units_told_; }
  /// The first thing told that no plant tells; empty where there was none.
  std::string fault() const;
  void forget();

 private:
  void instant(const core::Instant& instant) noexcept override;
  void finding(const core::Finding& finding) noexcept override { pending_.push_back(finding); }
  void add_bits(reference::InstantRecord& record, std::span<const core::WordChange> words, bool operations);
  void add_slots(reference::InstantRecord& record, std::span<const std::uint32_t> slots, bool operations);

  const core::PlantTables& tables_;
  SymbolPlaces places_;
  std::vector<core::Behaviour> behaviours_;
  std::unique_ptr<std::max_align_t[]> memory_;
  std::unique_ptr<core::Plant> plant_;
  std::vector<reference::InstantRecord> instants_;
  std::vector<core::Finding> pending_;  ///< told before their instant
  std::vector<bool> units_told_;
  std::string fault_;
  unsigned writes_ = 0;  ///< every third one goes by the word
};

}  // namespace symplant::property
