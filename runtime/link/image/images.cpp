// The plant's images as a Modbus server's tables.
#include "symplant/link/image/images.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>

#include "symplant/link/transfer_range.hpp"

namespace symplant::link::image {

namespace {

constexpr std::uint32_t kPlaneWordBits = 64;

// Words after the tables of operations: the losses seen, whether all is written again, and the number of the image.
constexpr std::size_t kLossesSeen = 0;
constexpr std::size_t kRewritten = 1;
constexpr std::size_t kImage = 2;
constexpr std::size_t kControlWords = 3;

std::vector<std::uint64_t> with_control_words(std::vector<std::uint64_t> image) {
  image.resize(image.size() + kControlWords);
  image[image.size() - kControlWords + kRewritten] = 1;  // nothing is awaited
  return image;
}

std::uint32_t size_of(const IoMap& map, Table table) { return map.sizes[static_cast<std::size_t>(table)]; }

std::vector<std::uint32_t> addresses_of_events(const tables::PlantTables& tables, const IoMap& map) {
  std::vector<std::uint32_t> addresses(tables.event_bits, tables::kNone);
  for (const IoPoint& point : map.points) {
    if (point.table == Table::discrete_input) addresses[tables.symbols[point.symbol].index] = point.number;
  }
  return addresses;
}

}  // namespace

std::span<const std::uint32_t> Images::ByAddress::at(std::uint32_t address) const noexcept {
  if (address + 1 >= first.size()) return {};
  return std::span(rows).subspan(first[address], first[address + 1] - first[address]);
}

Images::ByAddress Images::by_address(const IoMap& map, Table table) {
  ByAddress result;
  result.first.assign(size_of(map, table) + std::size_t{1}, 0);
  const auto each = [&](auto act) {
    for (std::uint32_t i = 0; i < map.points.size(); ++i) {
      const IoPoint& point = map.points[i];
      if (point.table != table) continue;
      for (std::size_t address = point.number; address <= point.last(); ++address) act(i, address);
    }
  };
  each([&](std::uint32_t, std::size_t address) { ++result.first[address + 1]; });
  for (std::size_t address = 1; address < result.first.size(); ++address)
    result.first[address] += result.first[address - 1];
  result.rows.resize(result.first.back());
  std::vector<std::uint32_t> next = result.first;
  each([&](std::uint32_t i, std::size_t address) { result.rows[next[address]++] = i; });
  return result;
}

Images::Images(const tables::PlantTables& tables, const IoMap& map, WordOrder word_order, RequestWatch* watch)
    : tables_(tables),
      points_(map.points),
      sizes_(map.sizes),
      coil_words_(bit_words(size_of(map, Table::coil))),
      discrete_words_(bit_words(size_of(map, Table::discrete_input))),
      coils_(by_address(map, Table::coil)),
      holding_registers_(by_address(map, Table::holding_register)),
      address_of_event_(addresses_of_events(tables, map)),
      applied_(initial_operations()),
      initial_(applied_),
      zeroed_(zero_masks()),
      scratch_(applied_.size()),
      status_block_(map.status_block),
      watchdog_(map.watchdog),
      word_order_(word_order),
      events_written_(tables.event_bits / kPlaneWordBits, 0),
      point_of_slot_(tables.event_slots, tables::kNone),
      rewriting_(size_of(map, Table::coil), size_of(map, Table::holding_register)),
      watch_(watch),
      operations_(with_control_words(applied_)),
      events_(std::vector<std::uint64_t>(discrete_words_ + register_words(size_of(map, Table::input_register)), 0)) {
  std::vector<bool> seen(size_of(map, Table::input_register));
  for (std::uint32_t i = 0; i < points_.size(); ++i) {
    const IoPoint& point = points_[i];
    if (point.table != Table::input_register || seen[point.number]) continue;
    seen[point.number] = true;  // the first of several symbols on one register gives the value
    point_of_slot_[tables.symbols[point.symbol].index] = i;
  }
  for (std::size_t table = 0; table < kTables; ++table) mapped_[table] = AddressSet(map.sizes[table]);
  for (const IoPoint& point : points_) mapped_[static_cast<std::size_t>(point.table)].add(point.number, point.width);
  if (watchdog_) mapped_[static_cast<std::size_t>(Table::holding_register)].add(*watchdog_, 1);
  for (const Table table : {Table::coil, Table::holding_register}) {
    AddressSet& used = used_[static_cast<std::size_t>(table)];
    used = mapped_[static_cast<std::size_t>(table)];
    if (const auto range = transfer_range(tables, map, table)) used.add(range->first, range->count);
  }
  if (watch_ != nullptr) watch_->writes.changed(written_coils(), written_registers());
}

/// A word of the image after a loss: operations whose policy is zero are without a command. Numbers go to 0.
std::uint64_t Images::released(std::size_t word, std::uint64_t bits) const noexcept {
  const std::uint64_t zero = word < coil_words_ ? initial_[word] & zeroed_[word] : 0;
  return (bits & ~zeroed_[word]) | zero;
}

/// The bits of operations whose policy on loss is zero.
std::vector<std::uint64_t> Images::zero_masks() const {
  std::vector<std::uint64_t> masks(applied_.size());
  for (const IoPoint& point : points_) {
    if (point.on_loss != OnLoss::zero) continue;
    if (point.table == Table::coil) set_bit(masks, point.number, true);
    if (point.table != Table::holding_register) continue;
    for (std::uint32_t address = point.number; address <= point.last(); ++address) {
      set_register(std::span(masks).subspan(coil_words_), address, 0xFFFF);
    }
  }
  return masks;
}

NumberLayout Images::number_layout(const IoPoint& point) const noexcept {
  return {point.number, point.width, point.word_order, tables_.symbols[point.symbol].type()};
}

std::vector<std::uint64_t> Images::initial_operations() const {
  std::vector<std::uint64_t> initial(tables_.symbols.size(), 0);
  for (const tables::InitialValue& value : tables_.initial_values) initial[value.symbol] = value.value;
  std::vector<std::uint32_t> leaders(tables_.symbols.size());
  std::iota(leaders.begin(), leaders.end(), 0U);
  for (const tables::SharedAddress& shared : tables_.shared_addresses) {
    initial[shared.symbol] = initial[shared.leader];
    leaders[shared.symbol] = shared.leader;
  }
  const std::uint32_t size = sizes_[static_cast<std::size_t>(Table::holding_register)];
  std::vector<bool> seen(size);
  std::vector<std::uint64_t> words(coil_words_ + register_words(size), 0);
  // Bit operations start without a command whatever their list says: an inverted one on, the others off. Numbers start
  // at their initial value, so that a PLC that reads a register before its first write gets the value of the plant.
  for (const IoPoint& point : points_) {
    if (point.table == Table::coil && tables_.symbols[leaders[point.symbol]].inverted()) {
      set_bit(words, point.number, true);
    }
    if (point.table != Table::holding_register || seen[point.number]) continue;
    seen[point.number] = true;
    set_number(std::span(words).subspan(coil_words_), number_layout(point), initial[point.symbol]);
  }
  return words;
}

void Images::apply_coils(plant::Plant& plant, std::size_t word, std::uint64_t now,
                         std::uint64_t changed) const noexcept {
  for (; changed != 0; changed &= changed - 1) {
    const auto bit = static_cast<std::uint32_t>(std::countr_zero(changed));
    const bool on = (now >> bit & 1) != 0;
    // All symbols of a coil have one address, so that a write to the first one is a write to all.
    const auto rows = coils_.at(static_cast<std::uint32_t>(word) * kBitsPerWord + bit);
    if (!rows.empty()) plant.set_operation(tables_.symbols[points_[rows.front()].symbol].index, on);
  }
}

void Images::apply_registers(plant::Plant& plant, std::size_t word, std::span<const std::uint64_t> now) const noexcept {
  const auto registers = now.subspan(coil_words_);
  const auto before = std::span(applied_).subspan(coil_words_);
  const auto changed = [&](std::uint32_t address) {
    return get_register(registers, address) != get_register(before, address);
  };
  const auto first = static_cast<std::uint32_t>(word) * kRegistersPerWord;
  for (std::uint32_t address = first; address < first + kRegistersPerWord; ++address) {
    if (!changed(address)) continue;
    // One write for each type on the register: the plant keeps symbols of one type and address equal.
    std::uint32_t types_written = 0;
    for (const std::uint32_t row : holding_registers_.at(address)) {
      const NumberLayout number = number_layout(points_[row]);
      const std::uint32_t bit = std::uint32_t{1} << static_cast<unsigned>(number.type);
      if ((types_written & bit) != 0) continue;
      types_written |= bit;
      bool written = false;  // because one of its lower registers changed
      for (std::uint32_t other = number.first; other < address; ++other) written = written || changed(other);
      if (written) continue;
      plant.set_operation_value(tables_.symbols[points_[row].symbol].index, number_at(registers, number));
    }
  }
}

/// Applies all differences between the image and the operations of the plant.
void Images::change_operations(plant::Plant& plant, std::span<const std::uint64_t> image) noexcept {
  for (std::size_t word = 0; word < image.size(); ++word) {
    const std::uint64_t changed = image[word] ^ applied_[word];
    if (changed == 0) continue;
    if (word < coil_words_) {
      apply_coils(plant, word, image[word], changed);
    } else {
      apply_registers(plant, word - coil_words_, image);
    }
  }
  std::copy(image.begin(), image.end(), applied_.begin());
}

void Images::read_operations(plant::Plant& plant) noexcept {
  take_operations();
  apply_operations(plant);
}

void Images::take_operations() noexcept {
  if (!operations_.update()) return;
  behind_ = true;
  if (watch_ != nullptr) watch_->found.took(operations_.latest()[applied_.size() + kImage]);
}

bool Images::is_complete(std::uint32_t losses) const noexcept {
  const auto control = operations_.latest().subspan(applied_.size());
  return control[kLossesSeen] == losses && control[kRewritten] != 0;
}

void Images::apply_operations(plant::Plant& plant) noexcept {
  if (!behind_) return;
  behind_ = false;
  change_operations(plant, operations_.latest().first(applied_.size()));
}

void Images::zero_operations(plant::Plant& plant) noexcept {
  for (std::size_t word = 0; word < scratch_.size(); ++word) scratch_[word] = released(word, applied_[word]);
  change_operations(plant, scratch_);
  behind_ = true;
}

void Images::write_event_word(std::uint32_t word, std::uint64_t bits) noexcept {
  std::uint64_t changed = bits ^ events_written_[word];
  events_written_[word] = bits;
  for (; changed != 0; changed &= changed - 1) {
    const auto bit = static_cast<std::uint32_t>(std::countr_zero(changed));
    const std::uint32_t address = address_of_event_[word * kPlaneWordBits + bit];
    const bool on = (bits >> bit & 1) != 0;
    if (address == tables::kNone || get_bit(events_.words(), address) == on) continue;
    set_bit(events_.words(), address, on);
    events_.touch(address / kBitsPerWord);
    if (watch_ != nullptr) watch_->missed.changed(address, on);
  }
}

/// `pulsed`: bits of the plant's word that changed more than once since the last image.
void Images::watch_pulses(std::uint32_t word, std::uint64_t pulsed) noexcept {
  for (; pulsed != 0; pulsed &= pulsed - 1) {
    const auto bit = static_cast<std::uint32_t>(std::countr_zero(pulsed));
    const std::uint32_t address = address_of_event_[word * kPlaneWordBits + bit];
    if (address != tables::kNone) watch_->missed.pulsed(address, get_bit(events_.words(), address));
  }
}

void Images::write_input_register(std::uint32_t slot, std::uint64_t value) noexcept {
  const std::uint32_t row = point_of_slot_[slot];
  if (row == tables::kNone) return;
  const IoPoint& point = points_[row];
  set_number(events_.words().subspan(discrete_words_), number_layout(point), value);
  for (std::uint32_t word = point.number / kRegistersPerWord; word <= point.last() / kRegistersPerWord; ++word) {
    events_.touch(discrete_words_ + word);
  }
}

void Images::write_status(const StatusBlock& status) noexcept {
  if (status_block_) {
    const auto registers = registers_of(status, word_order_);
    const auto inputs = events_.words().subspan(discrete_words_);
    for (std::uint32_t i = 0; i < kStatusRegisters; ++i) {
      const std::uint32_t address = *status_block_ + i;
      if (get_register(inputs, address) == registers[i]) continue;
      set_register(inputs, address, registers[i]);
      events_.touch(discrete_words_ + address / kRegistersPerWord);
    }
  }
  events_.publish();
}

void Images::write_events(const plant::Plant& plant, const StatusBlock& status, tables::Time now) noexcept {
  const auto bits = plant.events();
  if (watch_ != nullptr) watch_->missed.begin_image(now);
  if (first_write_) {
    for (std::uint32_t word = 0; word < events_written_.size(); ++word) write_event_word(word, bits[word]);
    for (std::uint32_t slot = 0; slot < tables_.event_slots; ++slot)
      write_input_register(slot, plant.event_value(slot));
    first_write_ = false;
  } else {
    for (const std::uint32_t word : plant.changed_events()) {
      write_event_word(word, bits[word]);
      if (watch_ != nullptr) watch_pulses(word, plant.pulsed_events(word));
    }
    for (const std::uint32_t slot : plant.changed_event_values()) write_input_register(slot, plant.event_value(slot));
  }
  write_status(status);
  if (watch_ != nullptr) watch_->missed.end_image();
}

Tables Images::tables() noexcept {
  events_.update();
  const auto operations = operations_.words();
  const auto events = events_.latest();
  const auto size = [this](Table table) { return sizes_[static_cast<std::size_t>(table)]; };
  return {.coils = {operations.first(coil_words_), size(Table::coil)},
          .discrete_inputs = {events.first(discrete_words_), size(Table::discrete_input)},
          .holding_registers = {operations.first(applied_.size()).subspan(coil_words_), size(Table::holding_register)},
          .input_registers = {events.subspan(discrete_words_), size(Table::input_register)}};
}

void Images::begin_request(std::uint32_t losses) noexcept {
  if (watch_ != nullptr) watch_->reads.begin();
  if (losses == losses_seen_) return;
  losses_seen_ = losses;
  rewriting_.begin(mapped_[static_cast<std::size_t>(Table::coil)],
                   mapped_[static_cast<std::size_t>(Table::holding_register)]);
  const auto words = operations_.words();
  for (std::size_t word = 0; word < zeroed_.size(); ++word) {
    const std::uint64_t now = released(word, words[word]);
    if (words[word] == now) continue;
    words[word] = now;
    operations_.touch(word);
  }
  if (watch_ != nullptr) watch_->writes.changed(written_coils(), written_registers());
  hand_over();
}

/// Publishes the operations together with the control words.
void Images::hand_over() noexcept {
  const auto control = operations_.words().subspan(applied_.size());
  control[kLossesSeen] = losses_seen_;
  control[kRewritten] = rewriting_.complete() ? 1 : 0;
  control[kImage] = ++image_;
  for (std::size_t word = 0; word < kControlWords; ++word) operations_.touch(applied_.size() + word);
  operations_.publish();
}

std::uint32_t Images::written(Table table, std::uint32_t first, std::uint32_t count, const ClientId& client) noexcept {
  if (count == 0) return 0;
  const bool coils = table == Table::coil;
  const std::size_t base = coils ? 0 : coil_words_;
  const std::uint32_t per_word = coils ? kBitsPerWord : kRegistersPerWord;
  const std::uint32_t last = first + count - 1;
  for (std::uint32_t word = first / per_word; word <= last / per_word; ++word) operations_.touch(base + word);
  rewriting_.wrote(coils, first, count);
  if (watch_ != nullptr) {
    OperationWrites& writes = watch_->writes;
    coils ? writes.wrote_coils(client, first, count, written_coils(), image_ + 1)
          : writes.wrote_registers(client, first, count, written_registers(), image_ + 1);
  }
  hand_over();
  return count - used_[static_cast<std::size_t>(table)].count(first, count);
}

void Images::end_request(Table table, std::uint32_t first, std::uint32_t count) noexcept {
  if (watch_ == nullptr) return;
  if (count != 0 && table == Table::discrete_input) {
    watch_->reads.read(events_.latest().first(discrete_words_), first, count);
  }
  watch_->reads.end();
}

void Images::written_all() noexcept {
  for (std::size_t word = 0; word < applied_.size(); ++word) operations_.touch(word);
  rewriting_.wrote(true, 0, sizes_[static_cast<std::size_t>(Table::coil)]);
  rewriting_.wrote(false, 0, sizes_[static_cast<std::size_t>(Table::holding_register)]);
  hand_over();
}

bool Images::changed_watchdog(Table table, std::uint32_t first, std::uint32_t count) noexcept {
  const bool written =
      watchdog_ && table == Table::holding_register && first <= *watchdog_ && *watchdog_ < first + count;
  if (!written) return false;
  const std::uint16_t value = get_register(written_registers(), *watchdog_);
  return std::exchange(watchdog_value_, value) != value;
}

}  // namespace symplant::link::image
