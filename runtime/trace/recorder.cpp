// Records what each instant changed.
#include "symplant/trace/recorder.hpp"

#include <algorithm>
#include <bit>

namespace symplant::trace {

Recorder::Recorder(const core::PlantTables& tables, std::size_t capacity)
    : tables_(tables),
      symbol_of_operation_(tables.operation_bits, core::kNoUnit),
      symbol_of_event_(tables.event_bits, core::kNoUnit),
      symbol_of_operation_slot_(tables.operation_slots, core::kNoUnit),
      symbol_of_event_slot_(tables.event_slots, core::kNoUnit),
      changed_(tables.symbols.size()),
      ring_(std::bit_ceil(std::max<std::size_t>(capacity, 2))),
      mask_(ring_.size() - 1) {
  for (std::uint32_t i = 0; i < tables.symbols.size(); ++i) {
    const core::SymbolRow& symbol = tables.symbols[i];
    const bool is_bit = symbol.type() == core::DataType::boolean;
    const bool operation = symbol.direction() == core::Direction::operation;
    auto& map = is_bit ? (operation ? symbol_of_operation_ : symbol_of_event_)
                       : (operation ? symbol_of_operation_slot_ : symbol_of_event_slot_);
    map[symbol.index] = i;
  }
}

void Recorder::note_bits(const core::WordChange& change, const std::vector<std::uint32_t>& symbol_of_bit) noexcept {
  for (std::uint64_t bits = change.bits; bits != 0; bits &= bits - 1) {
    const std::uint32_t symbol = symbol_of_bit[change.word * 64 + static_cast<std::uint32_t>(std::countr_zero(bits))];
    if (symbol != core::kNoUnit) changed_[changed_count_++] = symbol;
  }
}

void Recorder::instant(const core::Instant& instant) noexcept {
  changed_count_ = 0;
  for (const core::WordChange& change : instant.operations) note_bits(change, symbol_of_operation_);
  for (const core::WordChange& change : instant.events) note_bits(change, symbol_of_event_);
  for (const std::uint32_t slot : instant.operation_slots) changed_[changed_count_++] = symbol_of_operation_slot_[slot];
  for (const std::uint32_t slot : instant.event_slots) changed_[changed_count_++] = symbol_of_event_slot_[slot];
  std::sort(changed_.begin(), changed_.begin() + static_cast<std::ptrdiff_t>(changed_count_));

  std::size_t at = written_.load(std::memory_order_relaxed);
  const std::size_t end = read_.load(std::memory_order_acquire) + ring_.size();
  for (std::size_t i = 0; i < changed_count_; ++i) {
    if (at == end) {
      lost_.fetch_add(changed_count_ - i, std::memory_order_relaxed);
      break;
    }
    const std::uint32_t index = changed_[i];
    const core::SymbolRow& symbol = tables_.symbols[index];
    const bool operation = symbol.direction() == core::Direction::operation;
    std::uint64_t value = 0;
    if (symbol.type() == core::DataType::boolean) {
      value = (operation ? plant_->operation(symbol.index) : plant_->event(symbol.index)) ? 1 : 0;
    } else {
      value = operation ? plant_->operation_value(symbol.index) : plant_->event_value(symbol.index);
    }
    ring_[at++ & mask_] = {instant.time, value, index};
  }
  written_.store(at, std::memory_order_release);
}

}  // namespace symplant::trace
