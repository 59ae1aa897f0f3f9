// The link inside the process: a test or a library user acts as the PLC.
#include "symplant/link/loop_link.hpp"

#include <bit>

#include "symplant/tables/lists.hpp"

namespace symplant::link {

namespace {

constexpr std::uint32_t kWordBits = 64;

/// The image of operations at the start: without a command (inverted ones are on), numbers at their initial values.
std::vector<std::uint64_t> initial_operations(const tables::PlantTables& tables) {
  std::vector<std::uint64_t> words(tables.operation_bits / kWordBits + tables.operation_slots, 0);
  for (const tables::InitialValue& initial : tables.initial_values) {
    const tables::SymbolRow& symbol = tables.symbols[initial.symbol];
    if (symbol.direction() != tables::Direction::operation || symbol.type() == tables::DataType::boolean) continue;
    words[tables.operation_bits / kWordBits + symbol.index] = initial.value;
  }
  for (const tables::SymbolRow& symbol : tables.symbols) {
    if (symbol.direction() != tables::Direction::operation || !symbol.inverted()) continue;
    words[symbol.index / kWordBits] |= std::uint64_t{1} << (symbol.index % kWordBits);
  }
  for (const tables::SharedAddress& shared : tables.shared_addresses) {
    const tables::SymbolRow& symbol = tables.symbols[shared.symbol];
    if (symbol.direction() != tables::Direction::operation || symbol.type() != tables::DataType::boolean) continue;
    if (symbol.inverted() == tables.symbols[shared.leader].inverted()) continue;  // the leader decides
    words[symbol.index / kWordBits] ^= std::uint64_t{1} << (symbol.index % kWordBits);
  }
  return words;
}

}  // namespace

LoopLink::LoopLink(const tables::PlantTables& tables, std::uint32_t controller)
    : tables_(tables),
      controller_(controller),
      names_(tables),
      operation_words_(tables.operation_bits / kWordBits),
      event_words_(tables.event_bits / kWordBits),
      operations_(initial_operations(tables)),
      events_(std::vector<std::uint64_t>(event_words_ + tables.event_slots, 0)),
      applied_(initial_operations(tables)) {}

bool LoopLink::is(std::uint32_t symbol, tables::Direction direction, bool bit) const noexcept {
  if (symbol >= tables_.symbols.size()) return false;
  if (controller_ != kAllControllers && tables::controller_of(tables_, symbol) != controller_) return false;
  const tables::SymbolRow& row = tables_.symbols[symbol];
  return row.direction() == direction && (row.type() == tables::DataType::boolean) == bit;
}

std::uint32_t LoopLink::leader(std::uint32_t symbol) const noexcept {
  for (const tables::SharedAddress& shared : tables_.shared_addresses) {
    if (shared.symbol == symbol) return shared.leader;
  }
  return symbol;
}

template <class Write>
void LoopLink::write_all_of_address(std::uint32_t symbol, Write write) noexcept {
  const bool bit = tables_.symbols[symbol].type() == tables::DataType::boolean;
  const auto write_one = [&](std::uint32_t row) {
    if (is(row, tables::Direction::operation, bit)) write(tables_.symbols[row].index);
  };
  const std::uint32_t first = leader(symbol);
  write_one(first);
  for (const tables::SharedAddress& shared : tables_.shared_addresses) {
    if (shared.leader == first) write_one(shared.symbol);
  }
  operations_.publish();
}

bool LoopLink::set(std::uint32_t symbol, bool on) noexcept {
  if (!is(symbol, tables::Direction::operation, true)) return false;
  write_all_of_address(symbol, [this, on](std::uint32_t bit) {
    const std::uint64_t mask = std::uint64_t{1} << (bit % kWordBits);
    std::uint64_t& word = operations_.words()[bit / kWordBits];
    word = on ? word | mask : word & ~mask;
    operations_.touch(bit / kWordBits);
  });
  return true;
}

bool LoopLink::set_value(std::uint32_t symbol, std::uint64_t value) noexcept {
  if (!is(symbol, tables::Direction::operation, false)) return false;
  write_all_of_address(symbol, [this, value](std::uint32_t slot) {
    operations_.words()[operation_words_ + slot] = value;
    operations_.touch(operation_words_ + slot);
  });
  return true;
}

std::optional<bool> LoopLink::event(std::uint32_t symbol) noexcept {
  if (!is(symbol, tables::Direction::event, true)) return std::nullopt;
  events_.update();
  const std::uint32_t bit = tables_.symbols[symbol].index;
  return (events_.latest()[bit / kWordBits] >> (bit % kWordBits) & 1) != 0;
}

std::optional<std::uint64_t> LoopLink::event_value(std::uint32_t symbol) noexcept {
  if (!is(symbol, tables::Direction::event, false)) return std::nullopt;
  events_.update();
  return events_.latest()[event_words_ + tables_.symbols[symbol].index];
}

bool LoopLink::set(std::string_view symbol, bool on) {
  const auto row = names_.find(symbol);
  return row && set(*row, on);
}

bool LoopLink::set_value(std::string_view symbol, std::uint64_t value) {
  const auto row = names_.find(symbol);
  return row && set_value(*row, value);
}

std::optional<bool> LoopLink::event(std::string_view symbol) {
  const auto row = names_.find(symbol);
  return row ? event(*row) : std::nullopt;
}

std::optional<std::uint64_t> LoopLink::event_value(std::string_view symbol) {
  const auto row = names_.find(symbol);
  return row ? event_value(*row) : std::nullopt;
}

void LoopLink::read_operations(plant::Plant& plant, tables::Time /*now*/) noexcept {
  if (!operations_.update()) return;
  const auto image = operations_.latest();
  for (std::size_t word = 0; word < image.size(); ++word) {
    const std::uint64_t now = image[word];
    const std::uint64_t changed = now ^ applied_[word];
    if (changed == 0) continue;
    applied_[word] = now;
    if (word >= operation_words_) {
      plant.set_operation_value(static_cast<std::uint32_t>(word - operation_words_), now);
    } else {
      plant.set_operations(static_cast<std::uint32_t>(word), changed, now);
    }
  }
}

void LoopLink::write_event_word(std::size_t word, std::uint64_t value) noexcept {
  if (events_.words()[word] == value) return;
  events_.words()[word] = value;
  events_.touch(word);
}

void LoopLink::write_events(const plant::Plant& plant, const exec::CycleStatus& /*status*/) noexcept {
  const auto bits = plant.events();
  if (events_written_) {
    for (const std::uint32_t word : plant.changed_events()) write_event_word(word, bits[word]);
    for (const std::uint32_t slot : plant.changed_event_values()) {
      write_event_word(event_words_ + slot, plant.event_value(slot));
    }
  } else {
    for (std::size_t word = 0; word < event_words_; ++word) write_event_word(word, bits[word]);
    for (std::uint32_t slot = 0; slot < tables_.event_slots; ++slot) {
      write_event_word(event_words_ + slot, plant.event_value(slot));
    }
    events_written_ = true;
  }
  events_.publish();
}

std::string loop_fault(std::string_view rest) {
  return rest.empty() ? std::string() : "`loop:` takes nothing after the colon";
}

LinkResult open_loop_link(std::string_view /*rest*/, const LinkChoice& link, const tables::PlantTables& tables,
                          const plant::Plant* /*plant*/) {
  return std::make_unique<LoopLink>(tables, link.controller);
}

}  // namespace symplant::link
