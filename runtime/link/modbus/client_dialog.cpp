// The conversation with a PLC that is a Modbus TCP server.
#include "symplant/link/modbus/client_dialog.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "symplant/link/client/parts.hpp"
#include "symplant/link/image/table_view.hpp"
#include "symplant/link/modbus/client_map.hpp"
#include "symplant/link/modbus/fields.hpp"

namespace symplant::link::modbus {

namespace {

constexpr std::uint8_t kIllegalFunction = 1;
constexpr std::uint8_t kIllegalAddress = 2;
constexpr std::uint16_t kWholeLane = 0xFFFF;

/// The PLC may answer the same request otherwise soon.
bool is_busy(std::uint8_t code) { return code == 5 || code == 6; }

std::uint16_t reversed(std::uint16_t bits) noexcept {
  std::uint32_t value = bits;
  value = (value >> 1 & 0x5555) | (value & 0x5555) << 1;
  value = (value >> 2 & 0x3333) | (value & 0x3333) << 2;
  value = (value >> 4 & 0x0F0F) | (value & 0x0F0F) << 4;
  return static_cast<std::uint16_t>(value >> 8 | value << 8);
}

ClientRequest request_of(ClientRequest::Kind kind, Area area, const AddressRange& range) {
  return {kind, area, static_cast<std::uint16_t>(range.first), static_cast<std::uint16_t>(range.count)};
}

}  // namespace

ModbusDialog::ModbusDialog(const ClientSettings& settings, const IoMap& map)
    : settings_(settings),
      sizes_(map.sizes),
      owned_((sizes_[static_cast<std::size_t>(Table::discrete_input)] + kBitsInRegister - 1) / kBitsInRegister),
      continues_(sizes_[static_cast<std::size_t>(Table::input_register)]),
      exchange_(settings) {
  add_items(operations_, map);
  add_items(events_, map);
  plan_reads(operations_);
  plan_reads(events_);
  for (const IoPoint& point : map.points) {
    if (point.table == Table::discrete_input) {
      std::uint16_t& mask = owned_[point.number / kBitsInRegister];
      mask = static_cast<std::uint16_t>(mask | 1U << (point.number % kBitsInRegister));
    } else if (point.table == Table::input_register) {
      for (std::uint32_t number = point.number + 1; number <= point.last(); ++number) continues_[number] = true;
    }
  }
  for (std::uint32_t k = 1; map.status_block && k < kStatusRegisters; ++k) continues_[*map.status_block + k] = true;
}

std::string ModbusDialog::url() const { return "modbus-tcp://" + net::format_host_port(settings_.address); }

void ModbusDialog::add_items(Direction& direction, const IoMap& map) const {
  const auto items_of = [&](Table table) -> Items& {
    return direction.items[static_cast<std::size_t>(placement(table).area)];
  };
  for (const IoPoint& point : map.points) {
    if (point.table != direction.bits && point.table != direction.numbers) continue;
    items_of(point.table).push_back({address_of(placement(point.table), point.table, point.number), point.width});
  }
  if (map.status_block && direction.numbers == Table::input_register) {
    const std::uint32_t first = address_of(placement(Table::input_register), Table::input_register, *map.status_block);
    items_of(Table::input_register).push_back({first, kStatusRegisters});
  }
  for (Items& items : direction.items) {
    std::sort(items.begin(), items.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    items.erase(std::unique(items.begin(), items.end()), items.end());
  }
}

void ModbusDialog::plan_reads(Direction& direction) {
  std::vector<ClientRequest> requests;
  for (std::size_t i = 0; i < kAreas; ++i) {
    const auto area = static_cast<Area>(i);
    const std::uint32_t most = has_bits(area) ? kMostBitsRead : kMostRegistersRead;
    for (const PlannedRange& planned : plan_ranges(direction.items[i], most, true)) {
      requests.push_back(request_of(ClientRequest::Kind::read, area, planned.range));
    }
  }
  direction.requests = client::RequestList<ClientRequest>(std::move(requests));
}

std::vector<std::string> ModbusDialog::notes() const {
  std::size_t writes = 0;
  for (std::size_t i = 0; i < kAreas; ++i) {
    const std::uint32_t most = has_bits(static_cast<Area>(i)) ? kMostBitsWritten : kMostRegistersWritten;
    writes += plan_ranges(events_.items[i], most, false).size();
  }
  return client::request_notes(operations_.requests.size(), writes, events_.requests.size());
}

client::Fault ModbusDialog::transact(const ClientRequest& request, std::span<const std::uint16_t> values,
                                     ClientReply& reply) {
  client::Fault fault = exchange_.transact(request, values, reply);
  if (fault) return fault;
  requests_.fetch_add(1, std::memory_order_relaxed);
  has_[function_of(request)] = reply.exception != kIllegalFunction;
  return {};
}

tables::Refusal ModbusDialog::note_rejection(const ClientRequest& request, std::uint8_t code) {
  const std::string doing = request.kind == ClientRequest::Kind::read ? "reading " : "writing ";
  const std::uint32_t last = std::uint32_t{request.first} + request.count - 1;
  const std::string which = request.count == 1 ? " " + std::to_string(last)
                                               : "s " + std::to_string(request.first) + "-" + std::to_string(last);
  const tables::Refusal refusal{tables::Refusal::Side::modbus_client, function_of(request), code, request.first};
  rejections_.push_back(
      {is_busy(code) ? client::Answer::busy : client::Answer::refused, refusal,
       "the PLC rejects " + doing + area_name(request.area) + which + ": " + exception_text(code, request)});
  return refusal;
}

/// A server that answers function 43 badly or not at all is asked again for the rest, over a new connection.
client::Identity ModbusDialog::identify(client::Fault& fault) {
  std::string found;
  if (!mute_) {
    ClientReply reply;
    fault = transact({.kind = ClientRequest::Kind::identify}, {}, reply);
    if (fault.kind == client::Fault::Kind::interrupted) return {};
    if (fault) {
      mute_ = true;
      exchange_.close();
      fault = exchange_.open();
      if (fault) return {};
    } else if (const std::string text = identification_text(reply.data); !text.empty()) {
      found = "the PLC is `" + text + "`";
    }
  }
  if (found.empty()) found = "the PLC does not identify itself (function 43)";
  std::array<std::vector<std::uint64_t>, kTables> words;
  for (std::size_t i = 0; i < kTables; ++i) {
    const auto table = static_cast<Table>(i);
    const bool bits = table == Table::coil || table == Table::discrete_input;
    words[i].resize(bits ? image::bit_words(sizes_[i]) : image::register_words(sizes_[i]));
  }
  fault = read_all(operations_, {words[0], words[2]}, 0);
  const bool operations = !fault;
  if (operations || fault.kind == client::Fault::Kind::rejected) fault = read_back(words[1], words[3], 0);
  if (fault.kind == client::Fault::Kind::rejected) fault = {};
  if (fault) mute_ = false;  // it is not function 43 that gets no answer
  return {.kind = client::Identity::Kind::unverifiable,
          .message = found + (operations ? "; its operations can be read" : "; its operations cannot be read") +
                     ", but Modbus has nothing to compare the map with"};
}

void ModbusDialog::retry_rejected() noexcept {
  operations_.requests.retry();
  events_.requests.retry();
}

/// The items of a reading.
std::span<const AddressRange> ModbusDialog::items_in(const Direction& direction, const ClientRequest& request) {
  const Items& items = direction.items[static_cast<std::size_t>(request.area)];
  const auto before = [](const AddressRange& item, std::uint32_t address) { return item.first < address; };
  const auto begin = std::lower_bound(items.begin(), items.end(), request.first, before);
  return {begin, std::lower_bound(begin, items.end(), std::uint32_t{request.first} + request.count, before)};
}

/// Sends the requests of one direction.
class ModbusDialog::Reading {
 public:
  Reading(ModbusDialog& dialog, const Direction& direction, const Words& out)
      : dialog_(dialog), direction_(direction), out_(out) {}

  client::Fault send(const ClientRequest& request, bool first, client::Answer& answer) {
    ClientReply reply;
    if (client::Fault fault = dialog_.transact(request, {}, reply)) return fault;
    if (reply.exception == 0) {
      dialog_.take(direction_, reply, request, out_);
      return {};
    }
    answer = is_busy(reply.exception) ? client::Answer::busy : client::Answer::refused;
    if (reply.exception == kIllegalAddress && exact(request).size() > 1) {
      answer = client::Answer::over_gaps;
      return {};
    }
    dialog_.rejected_.fetch_add(1, std::memory_order_relaxed);
    dialog_.refusal_ = {tables::Refusal::Side::modbus_client, function_of(request), reply.exception, request.first};
    if (first) dialog_.note_rejection(request, reply.exception);
    return {};
  }

  std::vector<ClientRequest> exact(const ClientRequest& request) const {
    return requests(request.area, items_in(direction_, request), false);
  }

  std::vector<ClientRequest> halves(const ClientRequest& request) const {
    const auto items = items_in(direction_, request);
    if (items.size() < 2) return {};
    std::vector<ClientRequest> parts = requests(request.area, items.first(items.size() / 2), true);
    const auto others = requests(request.area, items.subspan(items.size() / 2), true);
    parts.insert(parts.end(), others.begin(), others.end());
    return parts;
  }

  /// Events are not left out because they cannot be read back.
  void leave_out(const ClientRequest& request) {
    if (direction_.bits == Table::coil) dialog_.leave_out(direction_, request);
  }

 private:
  static std::vector<ClientRequest> requests(Area area, std::span<const AddressRange> items, bool over_gaps) {
    std::vector<ClientRequest> requests;
    for (const PlannedRange& one : plan_ranges(items, kMostBitsRead, over_gaps)) {
      requests.push_back(request_of(ClientRequest::Kind::read, area, one.range));
    }
    return requests;
  }

  ModbusDialog& dialog_;
  const Direction& direction_;
  const Words& out_;
};

client::Fault ModbusDialog::read_all(Direction& direction, const Words& out, tables::Time now) {
  Reading reading(*this, direction, out);
  return direction.requests.run(now, reading);
}

/// Notes the operations at the addresses of a request.
void ModbusDialog::leave_out(const Direction& direction, const ClientRequest& request) {
  for (const Table table : {direction.bits, direction.numbers}) {
    const Placement& placed = placement(table);
    if (placed.area != request.area) continue;
    const bool bits = has_bits(placed.area);
    for (std::uint32_t k = 0; k < request.count; ++k) {
      const std::uint32_t address = std::uint32_t{request.first} + k;
      if (address < placed.offset) continue;
      const std::uint32_t number = address - placed.offset;
      const client::Lane lane{table, bits ? number / kBitsInRegister : number};
      const auto mask = static_cast<std::uint16_t>(bits ? 1U << (number % kBitsInRegister) : kWholeLane);
      left_out_.push_back({{lane, mask, 0}, refusal_});
    }
  }
}

/// Copies all of a reply, since nothing looks at addresses without a symbol.
void ModbusDialog::take(const Direction& direction, const ClientReply& reply, const ClientRequest& request,
                        const Words& out) const {
  const auto& bits = settings_.placements[static_cast<std::size_t>(direction.bits)];
  const auto& numbers = settings_.placements[static_cast<std::size_t>(direction.numbers)];
  if (has_bits(request.area)) return copy_bits(reply.data, request.count, out.bits, request.first - bits->offset);
  if (bits && bits->area == request.area) take_registers(direction.bits, reply, request, out.bits);
  if (numbers && numbers->area == request.area) take_registers(direction.numbers, reply, request, out.numbers);
}

/// Copies the registers of a reply that belong to the table.
void ModbusDialog::take_registers(Table table, const ClientReply& reply, const ClientRequest& request,
                                  std::span<std::uint64_t> words) const {
  const Placement& placed = placement(table);
  const bool packed = is_packed(placed, table);
  const std::uint32_t size = sizes_[static_cast<std::size_t>(table)];
  const std::uint32_t registers = packed ? (size + kBitsInRegister - 1) / kBitsInRegister : size;
  const std::uint32_t first = std::max<std::uint32_t>(request.first, placed.offset);
  const std::uint32_t end = std::min(std::uint32_t{request.first} + request.count, placed.offset + registers);
  for (std::uint32_t address = first; address < end; ++address) {
    const std::uint16_t value = on_wire(field(reply.data, std::size_t{2} * (address - request.first)));
    image::set_register(words, address - placed.offset, packed ? in_order(value) : value);
  }
}

client::Fault ModbusDialog::read(image::Tables& tables, tables::Time now) {
  return read_all(operations_, {tables.coils.words, tables.holding_registers.words}, now);
}

client::Fault ModbusDialog::read_back(std::span<std::uint64_t> discrete_inputs,
                                      std::span<std::uint64_t> input_registers, tables::Time now) {
  return read_all(events_, {discrete_inputs, input_registers}, now);
}

/// A register as the link has it, from the one of the protocol, or the other direction.
std::uint16_t ModbusDialog::on_wire(std::uint16_t value) const noexcept {
  if (settings_.byte_order == ByteOrder::high_first) return value;
  return static_cast<std::uint16_t>(value << 8 | value >> 8);
}

std::uint16_t ModbusDialog::in_order(std::uint16_t bits) const noexcept {
  return settings_.bit_order == BitOrder::low_first ? bits : reversed(bits);
}

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
      const bool near = end != 0 && (end - 1) / kBitsInRegister + 1 >= lane;
      std::uint32_t joined = end;
      while (near && joined < number && is_owned(joined)) ++joined;
      for (std::uint32_t between = end; near && joined == number && between < number; ++between) add(between);
      add(number);
      end = number + 1;
    }
  }
}

/// The changed registers. Those of one number stay together; packed bits are written as a whole register.
void ModbusDialog::add_registers(std::span<const client::LaneChange> changes) {
  std::uint32_t previous = std::numeric_limits<std::uint32_t>::max();  // the input register before
  for (const client::LaneChange& change : changes) {
    const std::uint32_t lane = change.lane.number;
    const std::uint32_t address = placement(change.lane.table).offset + lane;
    if (change.lane.table == Table::discrete_input) {
      const std::uint16_t value = on_wire(in_order(static_cast<std::uint16_t>(change.value & owned_[lane])));
      pieces_.push_back({{address, 1}, {value}});
      continue;
    }
    const bool joins = previous + 1 == lane && continues_[lane];
    if (!joins) pieces_.push_back({{address, 0}, {}});
    Piece& piece = pieces_.back();
    piece.values[piece.range.count++] = on_wire(change.value);
    previous = lane;
  }
}

client::Fault ModbusDialog::write(std::span<const client::LaneChange> changes,
                                  std::vector<client::Unwritten>& unwritten) {
  const auto begin_of_numbers = std::find_if(changes.begin(), changes.end(), [](const client::LaneChange& change) {
    return change.lane.table == Table::input_register;
  });
  const auto bits = changes.first(static_cast<std::size_t>(begin_of_numbers - changes.begin()));
  const auto numbers = changes.subspan(bits.size());
  const bool coils = !bits.empty() && has_bits(placement(Table::discrete_input).area);
  if (coils) {
    add_coils(bits);
    if (client::Fault fault = write_area(Area::coils, kMostBitsWritten, {bits, unwritten})) return fault;
  }
  add_registers(coils ? numbers : changes);
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
  const Placement& placed = placement(change.lane.table);
  return placed.offset + (has_bits(placed.area) ? client::kLaneBits * change.lane.number + bit : change.lane.number);
}

/// "needs functions 1 and 3 to read, and 15 or 5 to write coils; the PLC has 1, 3 and 5, not 15".
std::string ModbusDialog::functions() const {
  std::string needed;
  const auto need = [&](const std::string& text) { needed += (needed.empty() ? "needs " : ", ") + text; };
  for (std::size_t i = 0; i < kAreas; ++i) {
    const bool read = !operations_.items[i].empty() || !events_.items[i].empty();
    const ClientRequest request{.area = static_cast<Area>(i)};
    if (read) need(std::to_string(function_of(request)) + " to read " + area_name(request.area) + "s");
  }
  for (const Area area : {Area::coils, Area::holding_registers}) {
    if (events_.items[static_cast<std::size_t>(area)].empty()) continue;
    need(has_bits(area) ? "15 or 5 to write coils" : "16 to write holding registers (6 for those of 16 bits)");
  }
  std::string has;
  std::string lacks;
  for (const auto& [function, is_there] : has_) {
    std::string& list = is_there ? has : lacks;
    list += (list.empty() ? "" : ", ") + std::to_string(function);
  }
  return needed + (has.empty() ? "" : "; the PLC has " + has) + (lacks.empty() ? "" : "; it does not have " + lacks);
}

}  // namespace symplant::link::modbus
