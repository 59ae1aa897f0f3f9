// Records what each instant changed and found.
#include "symplant/trace/recorder.hpp"

#include <algorithm>
#include <bit>

#include "symplant/trace/value_traces.hpp"

namespace symplant::trace {
namespace {

std::uint32_t initial_word(const tables::UnitRow& unit) {
  return static_cast<std::uint32_t>(unit.initial | unit.initial << 8);
}

std::size_t parts_in(const tables::MaterialTables& material) {
  std::size_t parts = 0;
  for (const tables::TrackRow& track : material.tracks) parts += most_parts(material, track);
  for (const tables::PlaceRow& place : material.places) parts += place.holds;
  return parts;
}

/// What moves at most one part in a round.
std::size_t movers_in(const tables::MaterialTables& material) {
  return material.tracks.size() + material.transfers.size() + material.sources.size();
}

/// Not the bits of an output, which is finite.
constexpr std::uint64_t kNeverRecorded = ~std::uint64_t{0};

}  // namespace

std::size_t Recorder::enough_for_an_instant(const tables::PlantTables& tables, Detail detail) {
  // A symbol changes once and has at most two findings, a unit at most four; the rest is room for notes and
  // malfunctions.
  const tables::MaterialTables& material = tables.material;
  // Twice as many as there can be, and four for each element that moves them.
  const std::size_t parts = 2 * parts_in(material) + 4 * movers_in(material);
  const std::size_t motions = detail == Detail::motions ? material.tracks.size() + 2 * parts : 0;
  return 3 * tables.symbols.size() + 5 * tables.units.size() + tables.requirements.size() + 2 * parts + motions +
         material.transfers.size() + (material.empty() ? 0 : std::size_t{2} * engine::kMostByHand) +
         2 * tables.malfunctions.rows.size() + engine::kMostByHand + tables.values.rows.size() + tables.values.outputs;
}

std::size_t Recorder::enough_for_a_loop(const tables::PlantTables& tables, Detail detail) {
  constexpr std::size_t kMost = std::size_t{1} << 22;
  constexpr std::size_t kRounds = 1000;  // a loop is frozen after 200; what it moved may begin others
  const tables::MaterialTables& material = tables.material;
  // In a round each work changes each part at most.
  const std::size_t in_round = movers_in(material) + (material.work.empty() ? 0 : parts_in(material));
  const std::size_t enough = enough_for_an_instant(tables, detail);
  // A malfunction that ends its own `while` starts and ends 10,000 times at one time.
  const auto& malfunctions = tables.malfunctions.rows;
  if (std::any_of(malfunctions.begin(), malfunctions.end(), [](const auto& row) { return row.during; })) {
    return std::max(enough, kMost);
  }
  return std::max(enough, std::min(kMost, enough + 2 * kRounds * in_round));
}

Recorder::Recorder(const tables::PlantTables& tables, std::size_t capacity, Detail detail)
    : tables_(tables),
      symbol_of_operation_(tables.operation_bits, tables::kNone),
      symbol_of_event_(tables.event_bits, tables::kNone),
      symbol_of_operation_slot_(tables.operation_slots, tables::kNone),
      symbol_of_event_slot_(tables.event_slots, tables::kNone),
      changed_(tables.symbols.size()),
      detail_(detail),
      ring_(std::bit_ceil(std::max<std::size_t>(capacity, 2))),
      mask_(ring_.size() - 1),
      end_(ring_.size()) {
  for (std::uint32_t i = 0; i < tables.symbols.size(); ++i) {
    const tables::SymbolRow& symbol = tables.symbols[i];
    const bool is_bit = symbol.type() == tables::DataType::boolean;
    const bool operation = symbol.direction() == tables::Direction::operation;
    auto& map = is_bit ? (operation ? symbol_of_operation_ : symbol_of_event_)
                       : (operation ? symbol_of_operation_slot_ : symbol_of_event_slot_);
    map[symbol.index] = i;
  }
  units_.reserve(tables.units.size());
  for (const tables::UnitRow& unit : tables.units) units_.push_back(initial_word(unit));
  traces_ = traces_of(tables.values);
  outputs_.assign(traces_.size(), kNeverRecorded);
  pending_.assign((traces_.size() + 63) / 64, 0);
  expect_values();
}

/// All outputs are recorded at their next time.
void Recorder::expect_values() noexcept {
  for (std::size_t output = 0; output < traces_.size(); ++output) {
    outputs_[output] = kNeverRecorded;
    if (traces_[output] != 0) pending_[output / 64] |= std::uint64_t{1} << (output % 64);
  }
}

/// Outputs that changed, at the whole multiples of their times at which they differ from what was recorded last.
void Recorder::record_values(const engine::Instant& instant) noexcept {
  for (const std::uint32_t output : instant.values) {
    if (traces_[output] != 0) pending_[output / 64] |= std::uint64_t{1} << (output % 64);
  }
  for (std::size_t word = 0; word < pending_.size(); ++word) {
    for (std::uint64_t bits = pending_[word]; bits != 0; bits &= bits - 1) {
      const auto output = static_cast<std::uint32_t>(word * 64 + static_cast<std::size_t>(std::countr_zero(bits)));
      if (instant.time % traces_[output] != 0) continue;
      pending_[word] &= ~(std::uint64_t{1} << (output % 64));
      const auto now = std::bit_cast<std::uint64_t>(plant_->output(output));
      if (outputs_[output] == now) continue;
      outputs_[output] = now;
      if (!put({instant.time, now, output, Record::Kind::value})) {
        lost_changes_.fetch_add(1, std::memory_order_relaxed);
      }
    }
  }
}

void Recorder::note_bits(const engine::WordChange& change, const std::vector<std::uint32_t>& symbol_of_bit) noexcept {
  for (std::uint64_t bits = change.bits; bits != 0; bits &= bits - 1) {
    const std::uint32_t symbol = symbol_of_bit[change.word * 64 + static_cast<std::uint32_t>(std::countr_zero(bits))];
    if (symbol != tables::kNone) changed_[changed_count_++] = symbol;
  }
}

void Recorder::start_again() noexcept {
  if ((at_ & mask_) == 0 || read_.load(std::memory_order_acquire) != at_) return;
  skip_from_ = at_;
  at_ = (at_ | mask_) + 1;
  skip_to_ = at_;
  end_ = at_ + ring_.size();
}

/// Whether the ring has room for some records.
bool Recorder::has_room_for(std::size_t records) noexcept {
  end_ = std::max(read_.load(std::memory_order_acquire), skip_to_) + ring_.size();
  return end_ - at_ >= records;
}

bool Recorder::put(const Record& record) noexcept {
  if (at_ == written_.load(std::memory_order_relaxed)) start_again();
  if (at_ == end_) {
    end_ = std::max(read_.load(std::memory_order_acquire), skip_to_) + ring_.size();
    if (at_ == end_) return false;
  }
  ring_[at_++ & mask_] = record;
  return true;
}

/// False if there is nothing new.
bool Recorder::publish() noexcept {
  if (at_ == written_.load(std::memory_order_relaxed)) return false;
  ring_[(at_ - 1) & mask_].last = true;
  written_.store(at_, std::memory_order_release);
  return true;
}

void Recorder::record_symbols(const engine::Instant& instant) noexcept {
  changed_count_ = 0;
  for (const engine::WordChange& change : instant.operations) note_bits(change, symbol_of_operation_);
  for (const engine::WordChange& change : instant.events) note_bits(change, symbol_of_event_);
  for (const std::uint32_t slot : instant.operation_slots) changed_[changed_count_++] = symbol_of_operation_slot_[slot];
  for (const std::uint32_t slot : instant.event_slots) changed_[changed_count_++] = symbol_of_event_slot_[slot];
  if (changed_count_ > 1) {
    std::sort(changed_.begin(), changed_.begin() + changed_count_);
  }
  for (std::size_t i = 0; i < changed_count_; ++i) {
    const std::uint32_t index = changed_[i];
    const tables::SymbolRow& symbol = tables_.symbols[index];
    const bool operation = symbol.direction() == tables::Direction::operation;
    std::uint64_t value = 0;
    if (symbol.type() == tables::DataType::boolean) {
      value = (operation ? plant_->operation(symbol.index) : plant_->event(symbol.index)) ? 1 : 0;
    } else {
      value = operation ? plant_->operation_value(symbol.index) : plant_->event_value(symbol.index);
    }
    if (!put({instant.time, value, index})) {
      lost_changes_.fetch_add(changed_count_ - i, std::memory_order_relaxed);
      return;
    }
  }
}

void Recorder::record_units(const engine::Instant& instant) noexcept {
  for (const std::uint32_t unit : instant.units) {
    const plant::UnitView view = plant_->unit(unit);
    const auto word = static_cast<std::uint32_t>(pack_unit(view));
    if (units_[unit] == word) continue;
    units_[unit] = word;
    if (!put({instant.time, pack_motion(view), unit, Record::Kind::unit})) {
      lost_changes_.fetch_add(1, std::memory_order_relaxed);
    }
  }
}

void Recorder::record_tracks(const engine::Instant& instant) noexcept {
  for (const std::uint32_t track : instant.tracks) {
    const std::uint32_t parts = plant_->parts(track);
    if (!has_room(1 + std::size_t{2} * parts)) {
      lost_changes_.fetch_add(1, std::memory_order_relaxed);
      continue;
    }
    put({instant.time, parts, track, Record::Kind::track});
    for (std::uint32_t i = 0; i < parts; ++i) {
      const plant::PartView part = plant_->part(track, i);
      const plant::PartMotion motion = plant_->motion(track, i);
      put({instant.time, part.number, part.kind, Record::Kind::part_at});
      put({instant.time, static_cast<std::uint64_t>(motion.x), static_cast<std::uint32_t>(motion.v),
           Record::Kind::part_speed});
    }
  }
}

/// Counts the instants of one time; a further one begins with its number.
void Recorder::begin_instant(tables::Time time) noexcept {
  if (time != instant_time_) {
    instant_time_ = time;
    ordinal_ = 1;
  } else {
    ++ordinal_;
    if (!announced_) put({time, ordinal_, kInstantNote, Record::Kind::note});
  }
  announced_ = false;
}

void Recorder::begin_act(tables::Time time) noexcept {
  if (time != instant_time_ || announced_) return;
  announced_ = true;
  act(time, kInstantNote, ordinal_ + 1);
}

void Recorder::act(tables::Time time, std::uint32_t of, std::uint64_t value) noexcept {
  if (!note(time, of, value)) lost_changes_.fetch_add(1, std::memory_order_relaxed);
}

void Recorder::take_over() noexcept {
  expect_values();
  instant_time_ = -1;
  announced_ = false;
  for (std::uint32_t unit = 0; unit < units_.size(); ++unit) {
    units_[unit] = static_cast<std::uint32_t>(pack_unit(plant_->unit(unit)));
  }
}

void Recorder::instant(const engine::Instant& instant) noexcept {
  const std::size_t before = at_;
  begin_instant(instant.time);
  const bool numbered = at_ != before;
  const std::size_t first = at_;
  record_symbols(instant);
  record_units(instant);
  record_parts(instant.time, instant.parts);
  if (detail_ == Detail::motions) record_tracks(instant);
  record_malfunctions(instant);
  if (!traces_.empty()) record_values(instant);
  if (numbered && at_ == first) at_ = before;  // nothing to number
  if (publish()) ++instants_;
}

void Recorder::record_malfunctions(const engine::Instant& instant) noexcept {
  for (const engine::MalfunctionChange& change : instant.malfunctions) {
    const auto by = static_cast<std::uint64_t>(change.by);
    if (!put({instant.time, by, change.malfunction, Record::Kind::malfunction, {}, change.active})) {
      lost_changes_.fetch_add(1, std::memory_order_relaxed);
    }
  }
}

void Recorder::record_parts(tables::Time time, std::span<const engine::PartChange> parts) noexcept {
  for (const engine::PartChange& part : parts) {
    const bool changed = part.what == engine::PartChange::What::changed;
    const std::uint64_t move = pack_move(part.from, changed ? tables::kNone : part.to);
    if (end_ - at_ >= 2 || has_room_for(2)) {
      put({time, part.number, part.kind, Record::Kind::part, {}, part.by_hand});
      put({time, move, static_cast<std::uint32_t>(part.x), Record::Kind::part_move});
    } else {
      lost_changes_.fetch_add(1, std::memory_order_relaxed);
    }
  }
}

void Recorder::parts_before(tables::Time time, std::span<const engine::PartChange> parts) noexcept {
  record_parts(time, parts);
}

void Recorder::finding(const tables::Finding& finding) noexcept {
  std::uint64_t value = 0;
  if (finding.kind == tables::FindingKind::part_blocked) {
    const plant::TransferView transfer = plant_->transfer(finding.of);
    value = pack_parts(transfer.part, transfer.obstacle);
  }
  put_finding(finding, value);
}

void Recorder::put_finding(const tables::Finding& finding, std::uint64_t value) noexcept {
  if (!put({finding.time, value, finding.of, Record::Kind::finding, finding.kind, finding.more})) {
    lost_findings_.fetch_add(1, std::memory_order_relaxed);
  }
}

void Recorder::raise(tables::Time time, tables::FindingKind kind, std::uint32_t of, std::uint64_t value) noexcept {
  put_finding({time, of, kind, false}, value);
  publish();
}

bool Recorder::note(tables::Time time, std::uint32_t of, std::uint64_t value) noexcept {
  const bool noted = put({time, value, of, Record::Kind::note});
  publish();
  return noted;
}

}  // namespace symplant::trace
