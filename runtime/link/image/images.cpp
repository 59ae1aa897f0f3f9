// The images of a link's operations and events.
#include "symplant/link/image/images.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

#include "symplant/link/image/numbers.hpp"
#include "symplant/link/image/words.hpp"

namespace symplant::link::image {

namespace {

// Words after the planes of operations: the losses seen, whether all is written again, and the number of the image.
constexpr std::size_t kLossesSeen = 0;
constexpr std::size_t kRewritten = 1;
constexpr std::size_t kImage = 2;
constexpr std::size_t kControlWords = 3;

std::vector<std::uint64_t> with_control_words(std::vector<std::uint64_t> image) {
  image.resize(image.size() + kControlWords);
  image[image.size() - kControlWords + kRewritten] = 1;  // nothing is awaited
  return image;
}

}  // namespace

std::span<const std::uint32_t> Images::ByPosition::at(std::uint32_t position) const noexcept {
  if (position + 1 >= first.size()) return {};
  return std::span(rows).subspan(first[position], first[position + 1] - first[position]);
}

Images::ByPosition Images::by_position(const Map& map, Plane plane) {
  ByPosition result;
  result.first.assign(map.size(plane) + std::size_t{1}, 0);
  const auto each = [&](auto act) {
    for (const Point& point : map.points) {
      if (point.plane == plane) act(point);
    }
  };
  each([&](const Point& point) { ++result.first[std::size_t{point.position} + 1]; });
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  result.rows.resize(result.first.back());
  std::vector<std::uint32_t> next = result.first;
  each([&](const Point& point) { result.rows[next[point.position]++] = point.symbol; });
  return result;
}

Images::Images(const tables::PlantTables& tables, const Map& map, RequestWatch* watch)
    : tables_(tables),
      operation_words_(bit_words(map.size(Plane::operation_bits))),
      event_words_(bit_words(map.size(Plane::event_bits))),
      bits_(by_position(map, Plane::operation_bits)),
      numbers_(by_position(map, Plane::operation_numbers)),
      applied_(initial_operations(map)),
      initial_(applied_),
      zeroed_(zero_masks(map)),
      scratch_(applied_.size()),
      status_(map.status),
      events_written_(tables.event_bits / kBitsPerWord, 0),
      position_of_event_(tables.event_bits, tables::kNone),
      position_of_slot_(tables.event_slots, tables::kNone),
      type_of_slot_(tables.event_slots),
      watch_(watch),
      operations_(with_control_words(applied_)),
      events_(std::vector<std::uint64_t>(event_words_ + map.size(Plane::event_numbers), 0)) {
  std::vector<bool> seen(map.size(Plane::event_numbers));
  for (const Point& point : map.points) {
    const tables::SymbolRow& symbol = tables.symbols[point.symbol];
    if (point.plane == Plane::event_bits) position_of_event_[symbol.index] = point.position;
    if (point.plane != Plane::event_numbers || seen[point.position]) continue;
    seen[point.position] = true;  // the first of several symbols at one position gives the value
    position_of_slot_[symbol.index] = point.position;
    type_of_slot_[symbol.index] = symbol.type();
  }
}

/// A word of the image after a loss: operations whose policy is zero are without a command. Numbers go to 0.
std::uint64_t Images::released(std::size_t word, std::uint64_t bits) const noexcept {
  const std::uint64_t zero = word < operation_words_ ? initial_[word] & zeroed_[word] : 0;
  return (bits & ~zeroed_[word]) | zero;
}

/// The bits of operations whose policy on loss is zero.
std::vector<std::uint64_t> Images::zero_masks(const Map& map) const {
  std::vector<std::uint64_t> masks(applied_.size());
  for (const Point& point : map.points) {
    if (point.on_loss != OnLoss::zero) continue;
    if (point.plane == Plane::operation_bits) set_bit(masks, point.position, true);
    if (point.plane == Plane::operation_numbers) masks[operation_words_ + point.position] = ~std::uint64_t{0};
  }
  return masks;
}

std::vector<std::uint64_t> Images::initial_operations(const Map& map) const {
  std::vector<std::uint64_t> initial(tables_.symbols.size(), 0);
  for (const tables::InitialValue& value : tables_.initial_values) initial[value.symbol] = value.value;
  std::vector<std::uint32_t> leaders(tables_.symbols.size());
  std::iota(leaders.begin(), leaders.end(), 0U);
  for (const tables::SharedAddress& shared : tables_.shared_addresses) {
    initial[shared.symbol] = initial[shared.leader];
    leaders[shared.symbol] = shared.leader;
  }
  std::vector<bool> seen(map.size(Plane::operation_numbers));
  std::vector<std::uint64_t> words(operation_words_ + seen.size(), 0);
  // Bit operations start without a command whatever their list says: an inverted one on, the others off. Numbers start
  // at their initial value, so that a PLC that reads a number before its first write gets the value of the plant.
  for (const Point& point : map.points) {
    if (point.plane == Plane::operation_bits && tables_.symbols[leaders[point.symbol]].inverted()) {
      set_bit(words, point.position, true);
    }
    if (point.plane != Plane::operation_numbers || seen[point.position]) continue;
    seen[point.position] = true;
    words[operation_words_ + point.position] = number_of(initial[point.symbol], tables_.symbols[point.symbol].type());
  }
  return words;
}

void Images::apply_bits(plant::Plant& plant, std::size_t word, std::uint64_t now,
                        std::uint64_t changed) const noexcept {
  for (; changed != 0; changed &= changed - 1) {
    const auto bit = static_cast<std::uint32_t>(std::countr_zero(changed));
    const bool on = (now >> bit & 1) != 0;
    // All symbols of a position have one address, so that a write to the first one is a write to all.
    const auto rows = bits_.at(static_cast<std::uint32_t>(word) * kBitsPerWord + bit);
    if (!rows.empty()) plant.set_operation(tables_.symbols[rows.front()].index, on);
  }
}

void Images::apply_number(plant::Plant& plant, std::uint32_t position, std::uint64_t number) const noexcept {
  // One write for each type at the position: the plant keeps symbols of one type and address equal.
  std::uint32_t types_written = 0;
  for (const std::uint32_t row : numbers_.at(position)) {
    const tables::SymbolRow& symbol = tables_.symbols[row];
    const std::uint32_t bit = std::uint32_t{1} << static_cast<unsigned>(symbol.type());
    if ((types_written & bit) != 0) continue;
    types_written |= bit;
    plant.set_operation_value(symbol.index, value_of(number, symbol.type()));
  }
}

/// Applies all differences between the image and the operations of the plant.
void Images::change_operations(plant::Plant& plant, std::span<const std::uint64_t> image) noexcept {
  for (std::size_t word = 0; word < image.size(); ++word) {
    const std::uint64_t changed = image[word] ^ applied_[word];
    if (changed == 0) continue;
    if (word < operation_words_) {
      apply_bits(plant, word, image[word], changed);
    } else {
      apply_number(plant, static_cast<std::uint32_t>(word - operation_words_), image[word]);
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
    const std::uint32_t position = position_of_event_[word * kBitsPerWord + bit];
    const bool on = (bits >> bit & 1) != 0;
    if (position == tables::kNone || get_bit(events_.words(), position) == on) continue;
    set_bit(events_.words(), position, on);
    events_.touch(position / kBitsPerWord);
    if (watch_ != nullptr) watch_->missed.changed(position, on);
  }
}

/// `pulsed`: bits of the plant's word that changed more than once since the last image.
void Images::watch_pulses(std::uint32_t word, std::uint64_t pulsed) noexcept {
  for (; pulsed != 0; pulsed &= pulsed - 1) {
    const auto bit = static_cast<std::uint32_t>(std::countr_zero(pulsed));
    const std::uint32_t position = position_of_event_[word * kBitsPerWord + bit];
    if (position != tables::kNone) watch_->missed.pulsed(position, get_bit(events_.words(), position));
  }
}

void Images::write_event_number(std::uint32_t slot, std::uint64_t value) noexcept {
  if (position_of_slot_[slot] == tables::kNone) return;
  const std::size_t word = event_words_ + position_of_slot_[slot];
  events_.words()[word] = number_of(value, type_of_slot_[slot]);
  events_.touch(word);
}

void Images::write_status(const Status& status) noexcept {
  if (status_) {
    std::size_t word = event_words_ + *status_;
    for (const std::uint64_t number : numbers_of(status)) {
      if (events_.words()[word] != number) {
        events_.words()[word] = number;
        events_.touch(word);
      }
      ++word;
    }
  }
  events_.publish();
}

void Images::write_events(const plant::Plant& plant, const Status& status, tables::Time now) noexcept {
  const auto bits = plant.events();
  if (watch_ != nullptr) watch_->missed.begin_image(now);
  if (first_write_) {
    for (std::uint32_t word = 0; word < events_written_.size(); ++word) write_event_word(word, bits[word]);
    for (std::uint32_t slot = 0; slot < tables_.event_slots; ++slot) write_event_number(slot, plant.event_value(slot));
    first_write_ = false;
  } else {
    for (const std::uint32_t word : plant.changed_events()) {
      write_event_word(word, bits[word]);
      if (watch_ != nullptr) watch_pulses(word, plant.pulsed_events(word));
    }
    for (const std::uint32_t slot : plant.changed_event_values()) write_event_number(slot, plant.event_value(slot));
  }
  write_status(status);
  if (watch_ != nullptr) watch_->missed.end_image();
}

Planes Images::planes() noexcept {
  const auto operations = operations_.words().first(applied_.size());
  const auto events = events_.latest();
  return {.operation_bits = operations.first(operation_words_),
          .event_bits = events.first(event_words_),
          .operation_numbers = operations.subspan(operation_words_),
          .event_numbers = events.subspan(event_words_)};
}

void Images::touch(Plane plane, std::uint32_t first, std::uint32_t count) noexcept {
  if (count == 0) return;
  const std::uint32_t per_word = has_bits(plane) ? kBitsPerWord : 1;
  const std::size_t base = has_bits(plane) ? 0 : operation_words_;
  const std::uint32_t last = first + count - 1;
  for (std::uint32_t word = first / per_word; word <= last / per_word; ++word) operations_.touch(base + word);
}

void Images::touch_all() noexcept {
  for (std::size_t word = 0; word < applied_.size(); ++word) operations_.touch(word);
}

bool Images::release(std::uint32_t losses) noexcept {
  if (losses == losses_seen_) return false;
  losses_seen_ = losses;
  const auto words = operations_.words();
  for (std::size_t word = 0; word < zeroed_.size(); ++word) {
    const std::uint64_t now = released(word, words[word]);
    if (words[word] == now) continue;
    words[word] = now;
    operations_.touch(word);
  }
  return true;
}

void Images::publish(bool complete) noexcept {
  const auto control = operations_.words().subspan(applied_.size());
  control[kLossesSeen] = losses_seen_;
  control[kRewritten] = complete ? 1 : 0;
  control[kImage] = ++image_;
  for (std::size_t word = 0; word < kControlWords; ++word) operations_.touch(applied_.size() + word);
  operations_.publish();
}

}  // namespace symplant::link::image
