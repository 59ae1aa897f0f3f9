// One PLC program that runs: its cells, its scans, and what it wrote.
#include "symplant/program/instance.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>

#include "symplant/link/image/numbers.hpp"
#include "symplant/program/crash.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::program {
namespace {

using tables::DataType;
using tables::kNone;
using trace::seconds;

constexpr tables::Time kDefaultPeriod = 10 * tables::kMillisecond;
constexpr std::size_t kBlock = 8;  // cells that are compared at once

}  // namespace

Times times_of(const symplant_program& program, const Options& options) {
  Times times;
  const tables::Time own = program.period_ns;
  times.period = own != 0 ? own : options.period.value_or(kDefaultPeriod);
  if (options.period && *options.period != times.period) {
    times.error =
        fmt::format("program `{}` has a period of {}, not {}: remove the other one, or compile the program with it",
                    program.name, seconds(own), seconds(*options.period));
  } else if (times.period <= 0) {
    times.error = fmt::format("the period of program `{}` is 0: give one such as 10ms", program.name);
  }
  times.delay = options.delay.value_or(times.period);
  if (times.error.empty() && (times.delay < 1 || times.delay > times.period)) {
    times.error = fmt::format("the delay of {} of program `{}` is not from 1 ns to its period of {}",
                              seconds(times.delay), program.name, seconds(times.period));
  }
  return times;
}

Instance::Instance(const symplant_program& program, const Binding& binding, const Options& options, const Times& times,
                   plant::Plant& plant)
    : program_(program), options_(options), times_(times), plant_(plant), addresses_(program.count) {
  const tables::PlantTables& tables = plant.tables();
  read_bits_.assign(tables.event_bits / 64, 0);
  cell_of_bit_.assign(tables.event_bits, kNone);
  cell_of_slot_.assign(tables.event_slots, kNone);
  symbol_of_slot_.assign(tables.event_slots, kNone);
  std::vector<std::uint32_t> cell_of(program.count);
  std::uint32_t cells = 0;
  for (std::uint32_t i = 0; i < program.count; ++i) {
    const std::uint32_t symbol = binding.symbols[i];
    if (program.variables[i].writes == 0 || symbol == kNone) continue;
    cell_of[i] = cells++;
    writes_.push_back({symbol, number(symbol)});
  }
  cells = (cells + kBlock - 1) / kBlock * kBlock;
  written_.assign(cells, 0);
  for (std::uint32_t i = 0; i < program.count; ++i) {
    const std::uint32_t symbol = binding.symbols[i];
    if (program.variables[i].writes != 0 && symbol != kNone) continue;
    if (symbol == kNone) {
      cell_of[i] = cells++;
      continue;
    }
    const tables::SymbolRow& row = tables.symbols[symbol];
    std::uint32_t& cell = row.type() == DataType::boolean ? cell_of_bit_[row.index] : cell_of_slot_[row.index];
    if (cell == kNone) cell = cells++;  // two variables may read one symbol
    cell_of[i] = cell;
    if (row.type() == DataType::boolean) {
      read_bits_[row.index / 64] |= std::uint64_t{1} << (row.index % 64);
    } else {
      symbol_of_slot_[row.index] = symbol;
    }
  }
  cells_.assign(cells, 0);
  for (std::uint32_t i = 0; i < program.count; ++i) addresses_[i] = &cells_[cell_of[i]];
  changed_.reserve(writes_.size());
}

/// The value of a symbol as a program has it in its cell.
std::uint64_t Instance::number(std::uint32_t symbol) const noexcept {
  const tables::SymbolRow& row = plant_.tables().symbols[symbol];
  const bool operation = row.direction() == tables::Direction::operation;
  if (row.type() == DataType::boolean) return operation ? plant_.operation(row.index) : plant_.event(row.index);
  const std::uint64_t value = operation ? plant_.operation_value(row.index) : plant_.event_value(row.index);
  const std::uint32_t bits = link::image::bits_of(row.type());
  const std::uint64_t number = link::image::number_of(value, row.type());
  return bits == 64 ? number : number & ((std::uint64_t{1} << bits) - 1);
}

bool Instance::begin() noexcept {
  for (std::size_t i = 0; i < writes_.size(); ++i) written_[i] = writes_[i].at_start;
  return start();
}

/// Makes the program's instance, with cells as at a cold start.
bool Instance::start() noexcept {
  end();
  std::fill(cells_.begin(), cells_.end(), 0);
  for (std::size_t i = 0; i < writes_.size(); ++i) cells_[i] = writes_[i].at_start;
  for (std::uint32_t word = 0; word < read_bits_.size(); ++word) take_event_word(word);
  for (std::uint32_t slot = 0; slot < cell_of_slot_.size(); ++slot) {
    if (cell_of_slot_[slot] != kNone) cells_[cell_of_slot_[slot]] = number(symbol_of_slot_[slot]);
  }
  const Called called(program_.name, -1, plant_.now());
  instance_ = program_.create(addresses_.data());
  return instance_ != nullptr;
}

void Instance::end() noexcept {
  changed_.clear();
  if (instance_ == nullptr) return;
  const Called called(program_.name, -1, plant_.now());
  program_.destroy(instance_);
  instance_ = nullptr;
}

bool Instance::restart() noexcept {
  end();
  zero();
  return start();
}

void Instance::take_event_word(std::uint32_t word) noexcept {
  const std::uint64_t now = plant_.events()[word];
  for (std::uint64_t bits = read_bits_[word]; bits != 0; bits &= bits - 1) {
    const auto bit = static_cast<std::uint32_t>(std::countr_zero(bits));
    cells_[cell_of_bit_[word * 64 + bit]] = now >> bit & 1;
  }
}

void Instance::take_events() noexcept {
  for (const std::uint32_t word : plant_.changed_events()) take_event_word(word);
  for (const std::uint32_t slot : plant_.changed_event_values()) {
    if (cell_of_slot_[slot] != kNone) cells_[cell_of_slot_[slot]] = number(symbol_of_slot_[slot]);
  }
}

int Instance::scan(tables::Time now) noexcept {
  {
    const Called called(program_.name, now / times_.period, now);
    if (const int code = program_.scan(instance_, now); code != 0) return code;
  }
  sample_ = now + times_.delay;
  for (std::size_t block = 0; block < written_.size(); block += kBlock) {
    std::uint64_t differs = 0;
    for (std::size_t i = block; i < block + kBlock; ++i) differs |= cells_[i] ^ written_[i];
    if (differs == 0) continue;
    for (std::size_t i = block; i < block + kBlock; ++i) {
      if (cells_[i] == written_[i]) continue;
      changed_.push_back({static_cast<std::uint32_t>(i), written_[i]});
      written_[i] = cells_[i];
    }
  }
  return 0;
}

/// Writes an operation to the plant as written_ has it.
void Instance::put(std::uint32_t write) noexcept {
  const tables::SymbolRow& row = plant_.tables().symbols[writes_[write].symbol];
  if (row.type() == DataType::boolean) {
    plant_.set_operation(row.index, (written_[write] & 0xFF) != 0);
  } else {
    plant_.set_operation_value(row.index, link::image::value_of(written_[write], row.type()));
  }
}

void Instance::write_operations() noexcept {
  for (const Change& change : changed_) put(change.write);
  changed_.clear();
}

/// Takes back what is not yet written.
void Instance::drop() noexcept {
  for (const Change& change : changed_) written_[change.write] = change.before;
  changed_.clear();
}

/// Sets all operations to zero; true if that changes one.
bool Instance::zero() noexcept {
  bool changes = false;
  for (std::uint32_t i = 0; i < writes_.size(); ++i) {
    changes = changes || written_[i] != 0;
    written_[i] = 0;
    put(i);
  }
  return changes;
}

bool Instance::lose() noexcept {
  drop();
  return options_.on_loss == link::OnLoss::zero && zero();
}

}  // namespace symplant::program
