// What a Modbus client writes, and what happens if the PLC refuses it.
#include <algorithm>
#include <bit>
#include <limits>

#include "symplant/link/modbus/client_dialog.hpp"
#include "symplant/link/modbus/client_map.hpp"

namespace symplant::link::modbus {

/// The changed coils, and mapped ones between two of them if that joins their requests: a lane has all its values.
void ModbusDialog::add_coils(std::span<const client::LaneChange> changes) {
  const std::uint32_t offset = placement(Table::discrete_input).offset;
  std::uint32_t lane = 0;
  std::uint16_t bits = 0;    // of the lane
  std::uint16_t before = 0;  // of the change before it
  const auto add = [&](std::uint32_t number) {
    const std::uint16_t values = number / kBitsInRegister == lane ? bits : before;
    pieces_.push_back({{offset + number, 1}, {static_cast<std::uint16_t>(values >> number % kBitsInRegister & 1)}});
  };
  const auto is_owned = [&](std::uint32_t number) {
    return (owned_[number / kBitsInRegister] >> number % kBitsInRegister & 1) != 0;
  };
  std::uint32_t end = 0;  // the number after the latest piece
  for (const client::LaneChange& one : changes) {
    lane = one.lane.number;
    before = std::exchange(bits, one.value);
    for (std::uint32_t mask = one.mask; mask != 0; mask &= mask - 1) {
      const std::uint32_t number = kBitsInRegister * lane + static_cast<std::uint32_t>(std::countr_zero(mask));
      const bool is_near = end != 0 && (end - 1) / kBitsInRegister + 1 >= lane;
      std::uint32_t joined = end;
      while (is_near && joined < number && is_owned(joined)) ++joined;
      for (std::uint32_t between = end; is_near && joined == number && between < number; ++between) add(between);
      add(number);
      end = number + 1;
    }
  }
}

/// Packed bits are written as a whole register.
void ModbusDialog::add_packed(std::span<const client::LaneChange> changes) {
  for (const client::LaneChange& change : changes) {
    const std::uint32_t lane = change.lane.number;
    const std::uint16_t value = on_wire(in_order(static_cast<std::uint16_t>(change.value & owned_[lane])));
    pieces_.push_back({{placement(Table::discrete_input).offset + lane, 1}, {value}});
  }
}

/// The changed registers of numbers. Those of one number stay together.
void ModbusDialog::add_numbers(std::span<const client::LaneChange> changes) {
  std::vector<std::pair<std::uint32_t, std::uint16_t>> registers;
  registers.reserve(changes.size());
  for (const client::LaneChange& change : changes) {
    registers.emplace_back(registers_[change.lane.number], on_wire(change.value));
  }
  std::sort(registers.begin(), registers.end());
  std::uint32_t previous = std::numeric_limits<std::uint32_t>::max();  // the input register before
  for (const auto& [number, value] : registers) {
    const bool joins = previous + 1 == number && continues_[number];
    if (!joins) pieces_.push_back({{placement(Table::input_register).offset + number, 0}, {}});
    Piece& piece = pieces_.back();
    piece.values[piece.range.count++] = value;
    previous = number;
  }
}

client::Fault ModbusDialog::write(std::span<const client::LaneChange> changes,
                                  std::vector<client::Unwritten>& unwritten) {
  const auto begin_of_numbers = std::find_if(changes.begin(), changes.end(), [](const client::LaneChange& change) {
    return change.lane.plane == Plane::event_numbers;
  });
  const auto bits = changes.first(static_cast<std::size_t>(begin_of_numbers - changes.begin()));
  const auto numbers = changes.subspan(bits.size());
  const bool coils = !bits.empty() && has_bits(placement(Table::discrete_input).area);
  if (coils) {
    add_coils(bits);
    if (client::Fault fault = write_area(Area::coils, kMostBitsWritten, {bits, unwritten})) return fault;
  } else {
    add_packed(bits);
  }
  add_numbers(numbers);
  return write_area(Area::holding_registers, kMostRegistersWritten, {coils ? numbers : changes, unwritten});
}

/// Writes the pieces and forgets them.
client::Fault ModbusDialog::write_area(Area area, std::uint32_t most, const Writing& writing) {
  std::sort(pieces_.begin(), pieces_.end(),
            [](const Piece& a, const Piece& b) { return a.range.first < b.range.first; });
  ranges_.clear();
  values_.clear();
  for (const Piece& piece : pieces_) {
    ranges_.push_back(piece.range);
    values_.insert(values_.end(), piece.values.begin(), piece.values.begin() + piece.range.count);
  }
  pieces_.clear();
  for (const PlannedRange& planned : plan_ranges(ranges_, most, false)) {
    if (client::Fault fault = write_range(area, planned, writing)) return fault;
  }
  return {};
}

/// By function 15 or 16; if the PLC does not have it, by 5 or 6 from then on.
client::Fault ModbusDialog::write_range(Area area, const PlannedRange& planned, const Writing& writing) {
  if (singly_[static_cast<std::size_t>(area)]) return write_pieces(area, planned, writing);
  const ClientRequest request = request_of(ClientRequest::Kind::write, area, planned.range);
  ClientReply reply;
  if (client::Fault fault = transact(request, std::span(values_).subspan(planned.item, planned.range.count), reply)) {
    return fault;
  }
  if (reply.exception == kIllegalFunction) {
    singly_[static_cast<std::size_t>(area)] = true;
    return write_pieces(area, planned, writing);
  }
  if (reply.exception != 0) refuse(request, reply.exception, planned.range, writing);
  return {};
}

/// Each piece alone. A number of several registers still needs function 16: by 6 the PLC could see a half of it. If
/// the PLC does not have the function for one value either, the other one is tried again the next time.
client::Fault ModbusDialog::write_pieces(Area area, const PlannedRange& planned, const Writing& writing) {
  const auto before = [](const AddressRange& piece, std::uint32_t address) { return piece.first < address; };
  std::size_t item = planned.item;
  for (auto piece = std::lower_bound(ranges_.begin(), ranges_.end(), planned.range.first, before);
       piece != ranges_.end() && piece->first < planned.range.end(); ++piece) {
    const auto values = std::span(values_).subspan(item, piece->count);
    item += piece->count;
    const bool one = piece->count == 1;
    ClientRequest request = request_of(one ? ClientRequest::Kind::write_one : ClientRequest::Kind::write, area, *piece);
    request.value = values.front();
    ClientReply reply;
    if (client::Fault fault = transact(request, values, reply)) return fault;
    if (one && reply.exception == kIllegalFunction) singly_[static_cast<std::size_t>(area)] = false;
    if (reply.exception != 0) refuse(request, reply.exception, *piece, writing);
  }
  return {};
}

/// Notes the changes at these addresses, which the PLC did not take.
void ModbusDialog::refuse(const ClientRequest& request, std::uint8_t code, const AddressRange& range,
                          const Writing& writing) {
  const client::Answer answer = is_busy(code) ? client::Answer::busy : client::Answer::refused;
  rejected_.fetch_add(1, std::memory_order_relaxed);
  const tables::Refusal refusal = note_rejection(request, code);
  for (const client::LaneChange& change : writing.changes) {
    client::LaneChange part = change;
    for (std::uint32_t bit = 0; bit < client::kLaneBits; ++bit) {
      const std::uint32_t address = address_in(change, bit);
      const bool written = address >= range.first && address < range.end();
      if (!written) part.mask = static_cast<std::uint16_t>(part.mask & ~(1U << bit));
    }
    if (part.mask != 0) writing.unwritten.push_back({part, answer, refusal});
  }
}

/// The address at which a bit of a change is written.
std::uint32_t ModbusDialog::address_in(const client::LaneChange& change, std::uint32_t bit) const {
  const Placement& placed = placement(table_of(change.lane.plane));
  if (has_bits(placed.area)) return placed.offset + client::kLaneBits * change.lane.number + bit;
  const bool number = change.lane.plane == Plane::event_numbers;
  return placed.offset + (number ? registers_[change.lane.number] : change.lane.number);
}

}  // namespace symplant::link::modbus
