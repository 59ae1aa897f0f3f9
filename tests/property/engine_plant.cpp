// Maps what the engine's observer receives to symbols.
#include "property/engine_plant.hpp"

#include <algorithm>
#include <bit>

namespace symplant::property {
namespace {

constexpr std::uint32_t kNoSymbol = 0xFFFF'FFFF;

}  // namespace

SymbolIndexes::SymbolIndexes(const tables::PlantTables& tables)
    : operation_bits(tables.operation_bits, kNoSymbol),
      event_bits(tables.event_bits, kNoSymbol),
      operation_slots(tables.operation_slots, kNoSymbol),
      event_slots(tables.event_slots, kNoSymbol) {
  for (std::uint32_t i = 0; i < tables.symbols.size(); ++i) {
    const tables::SymbolRow& row = tables.symbols[i];
    const bool operation = row.direction() == tables::Direction::operation;
    if (row.type() == tables::DataType::boolean) {
      (operation ? operation_bits : event_bits)[row.index] = i;
    } else {
      (operation ? operation_slots : event_slots)[row.index] = i;
    }
  }
}

EnginePlant::EnginePlant(const tables::PlantTables& tables, const std::vector<engine::Behaviour>& behaviours)
    : tables_(tables),
      indexes_(tables),
      behaviours_(behaviours),
      units_reported_(tables.units.size()),
      value_trace_(tables.values) {
  const std::size_t size = plant::Plant::memory_size(tables, behaviours_);
  const std::size_t pieces = size / sizeof(std::max_align_t) + 1;
  memory_ = std::make_unique_for_overwrite<std::max_align_t[]>(pieces);
  // Memory that the engine does not write must not matter.
  std::fill_n(reinterpret_cast<unsigned char*>(memory_.get()), pieces * sizeof(std::max_align_t), 0xA5);
  plant_ =
      std::make_unique<plant::Plant>(tables, std::span(reinterpret_cast<std::byte*>(memory_.get()), size), behaviours_);
}

void EnginePlant::write(std::uint32_t symbol, std::uint64_t value) {
  const tables::SymbolRow& row = tables_.symbols[symbol];
  const std::uint64_t bit = std::uint64_t{1} << (row.index % 64);
  if (row.type() == tables::DataType::boolean && ++writes_ % 3 == 0) {
    plant_->set_operations(row.index / 64, bit,
                           value != 0 ? ~std::uint64_t{0} : 0);  // bits outside the mask have no meaning
  } else if (row.type() == tables::DataType::boolean) {
    plant_->set_operation(row.index, value != 0);
  } else {
    plant_->set_operation_value(row.index, value);
  }
}

std::uint64_t EnginePlant::value(std::uint32_t symbol) const {
  const tables::SymbolRow& row = tables_.symbols[symbol];
  const bool operation = row.direction() == tables::Direction::operation;
  if (row.type() == tables::DataType::boolean) {
    return (operation ? plant_->operation(row.index) : plant_->event(row.index)) ? 1 : 0;
  }
  return operation ? plant_->operation_value(row.index) : plant_->event_value(row.index);
}

void EnginePlant::forget() {
  instants_.clear();
  std::fill(units_reported_.begin(), units_reported_.end(), false);
}

std::string EnginePlant::fault() const {
  if (!pending_parts_.empty()) return "a part was reported, its instant was not";
  return pending_.empty() ? fault_ : "a finding was reported, its instant was not";
}

void EnginePlant::add_bits(reference::InstantRecord& record, std::span<const engine::WordChange> words,
                           bool operations) {
  const engine::BitWords plane = operations ? plant_->operations() : plant_->events();
  for (const engine::WordChange& change : words) {
    if (change.bits == 0) fault_ = "a word without a change was reported";
    for (std::uint64_t rest = change.bits; rest != 0; rest &= rest - 1) {
      const auto bit = static_cast<std::uint32_t>(std::countr_zero(rest));
      const std::uint32_t symbol = (operations ? indexes_.operation_bits : indexes_.event_bits)[change.word * 64 + bit];
      if (symbol == kNoSymbol) {
        fault_ = "a bit of no symbol was reported";
        continue;
      }
      record.changes.emplace_back(symbol, (plane[change.word] >> bit) & 1);
    }
  }
}

void EnginePlant::add_slots(reference::InstantRecord& record, std::span<const std::uint32_t> slots, bool operations) {
  for (const std::uint32_t slot : slots) {
    const std::uint32_t symbol = (operations ? indexes_.operation_slots : indexes_.event_slots)[slot];
    record.changes.emplace_back(symbol, operations ? plant_->operation_value(slot) : plant_->event_value(slot));
  }
}

void EnginePlant::parts_before(tables::Time, std::span<const engine::PartChange> parts) noexcept {
  pending_parts_.insert(pending_parts_.end(), parts.begin(), parts.end());
}

void EnginePlant::instant(const engine::Instant& instant) noexcept {
  reference::InstantRecord record;
  record.time = instant.time;
  record.findings = std::move(pending_);
  pending_.clear();
  record.parts = std::move(pending_parts_);
  pending_parts_.clear();
  record.parts.insert(record.parts.end(), instant.parts.begin(), instant.parts.end());
  add_bits(record, instant.operations, true);
  add_bits(record, instant.events, false);
  add_slots(record, instant.operation_slots, true);
  add_slots(record, instant.event_slots, false);
  std::sort(record.changes.begin(), record.changes.end());
  for (const std::uint32_t unit : instant.units) {
    if (unit >= units_reported_.size()) {
      fault_ = "an unknown unit was reported";
      continue;
    }
    units_reported_[unit] = true;
  }
  record.malfunctions.assign(instant.malfunctions.begin(), instant.malfunctions.end());
  record.values = value_trace_.lines_at(instant.time, *plant_);
  const bool silent = record.changes.empty() && record.findings.empty() && record.parts.empty() &&
                      record.malfunctions.empty() && record.values.empty();
  if (!silent) instants_.push_back(std::move(record));
}

}  // namespace symplant::property
