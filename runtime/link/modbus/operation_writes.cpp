// Finds operations that came and went between two cycles, and those that several clients write.
#include "symplant/link/modbus/operation_writes.hpp"

#include <algorithm>
#include <bit>

#include "symplant/link/image/position_set.hpp"
#include "symplant/link/image/words.hpp"
#include "symplant/tables/missed_pulse.hpp"

namespace symplant::link::modbus {

namespace {

/// By address of a table: the first symbol, or tables::kNone.
std::vector<std::uint32_t> symbols_of(const IoMap& map, Table table) {
  std::vector<std::uint32_t> symbols(map.sizes[static_cast<std::size_t>(table)], tables::kNone);
  for (const IoPoint& point : map.points) {
    if (point.table != table) continue;
    for (std::uint32_t address = point.number; address <= point.last(); ++address) {
      if (symbols[address] == tables::kNone) symbols[address] = point.symbol;
    }
  }
  return symbols;
}

}  // namespace

OperationWrites::OperationWrites(const IoMap& map, image::ServerFindings& findings)
    : findings_(findings),
      coils_{{}, symbols_of(map, Table::coil)},
      registers_{{}, symbols_of(map, Table::holding_register)},
      changes_(coils_.symbols.size()) {
  coils_.words.resize(image::bit_words(static_cast<std::uint32_t>(coils_.symbols.size())));
  registers_.words.resize(image::lane_words(static_cast<std::uint32_t>(registers_.symbols.size())));
  std::uint32_t symbols = 0;
  for (const IoPoint& point : map.points) symbols = std::max(symbols, point.symbol + 1);
  reported_.resize(symbols);
}

void OperationWrites::wrote_coils(const ClientId& client, std::uint32_t first, std::uint32_t count,
                                  std::span<const std::uint64_t> words, std::uint64_t image) noexcept {
  const Write write{client, image, &coils_, first, count};
  Clock::time_point now{};
  image::for_words(first, count, [&](std::size_t word, std::uint64_t /*mask*/) {
    std::uint64_t changed = words[word] ^ coils_.words[word];
    if (changed != 0 && now == Clock::time_point()) now = Clock::now();
    for (; changed != 0; changed &= changed - 1) {
      const auto bit = static_cast<std::uint32_t>(std::countr_zero(changed));
      const std::uint32_t coil = static_cast<std::uint32_t>(word) * image::kBitsPerWord + bit;
      if (coils_.symbols[coil] == tables::kNone) continue;
      find_unsampled(coil, (words[word] >> bit & 1) != 0, now, image);
      find_other_writer(write, coil);
    }
    coils_.words[word] = words[word];
  });
  note(write);
}

void OperationWrites::wrote_registers(const ClientId& client, std::uint32_t first, std::uint32_t count,
                                      std::span<const std::uint64_t> words, std::uint64_t image) noexcept {
  const Write write{client, image, &registers_, first, count};
  const std::uint32_t end = first + count;
  for (std::uint32_t word = first / image::kLanesPerWord; word * image::kLanesPerWord < end; ++word) {
    if (words[word] == registers_.words[word]) continue;
    for (std::uint32_t address = word * image::kLanesPerWord; address < (word + 1) * image::kLanesPerWord; ++address) {
      const bool same = image::get_lane(words, address) == image::get_lane(registers_.words, address);
      if (!same && registers_.symbols[address] != tables::kNone) find_other_writer(write, address);
    }
    registers_.words[word] = words[word];
  }
  note(write);
}

void OperationWrites::changed(std::span<const std::uint64_t> coils, std::span<const std::uint64_t> registers) noexcept {
  std::copy(coils.begin(), coils.end(), coils_.words.begin());
  std::copy(registers.begin(), registers.end(), registers_.words.begin());
}

void OperationWrites::left(const ClientId& client) noexcept {
  for (Write& write : writes_) {
    if (write.client.connection == client.connection) write = {};
  }
}

/// Remembers a write; one that repeats the last write of the same client takes no more room.
void OperationWrites::note(const Write& write) noexcept {
  const auto same = std::find_if(writes_.begin(), writes_.end(), [&](const Write& other) {
    return other.client.connection == write.client.connection && other.table == write.table &&
           other.first == write.first && other.count == write.count;
  });
  if (same != writes_.end()) {
    same->image = write.image;
    return;
  }
  writes_[next_] = write;
  next_ = (next_ + 1) % writes_.size();
}

/// A coil has a new value; the one before came with an image that no cycle may have taken, and is missed unless it is
/// the one that the cycle has.
void OperationWrites::find_unsampled(std::uint32_t coil, bool on, Clock::time_point now, std::uint64_t image) noexcept {
  Change& last = changes_[coil];
  const bool unsampled = last.image > findings_.taken();
  const bool returns = unsampled && !last.returned;
  if (returns) {
    const auto length = std::chrono::duration_cast<std::chrono::nanoseconds>(now - last.time).count();
    const std::uint64_t pulse = pack(tables::MissedPulse{!on, length, 0});
    findings_.add({tables::FindingKind::not_sampled, coils_.symbols[coil], pulse}, last.image, image);
  }
  last = {image, now, returns};
}

/// An address has a new value; another client has written the one before, and the cycle has not taken it.
void OperationWrites::find_other_writer(const Write& write, std::uint32_t address) noexcept {
  const std::uint32_t symbol = write.table->symbols[address];
  if (reported_[symbol] != 0) return;
  for (const Write& other : writes_) {
    if (other.table != write.table || other.client.connection == write.client.connection) continue;
    if (other.image <= findings_.taken() || address < other.first || address - other.first >= other.count) continue;
    reported_[symbol] = 1;
    findings_.add(
        {tables::FindingKind::several_writers, symbol, std::uint64_t{other.client.ipv4} << 32 | write.client.ipv4});
    return;
  }
}

}  // namespace symplant::link::modbus
