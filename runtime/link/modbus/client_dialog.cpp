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

constexpr std::uint8_t kIllegalAddress = 2;

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
  for (std::size_t i = 0; i < kAreas; ++i) {
    const auto area = static_cast<Area>(i);
    const std::uint32_t most = has_bits(area) ? kMostBitsRead : kMostRegistersRead;
    for (const PlannedRange& planned : plan_ranges(direction.items[i], most, true)) {
      direction.requests.push_back({request_of(ClientRequest::Kind::read, area, planned.range)});
    }
  }
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
  if (!fault) requests_.fetch_add(1, std::memory_order_relaxed);
  return fault;
}

void ModbusDialog::note_rejection(const ClientRequest& request, std::uint8_t code) {
  rejected_.fetch_add(1, std::memory_order_relaxed);
  const std::string doing = request.kind == ClientRequest::Kind::read ? "reading " : "writing ";
  const std::uint32_t last = std::uint32_t{request.first} + request.count - 1;
  const std::string which = request.count == 1 ? " " + std::to_string(last)
                                               : "s " + std::to_string(request.first) + "-" + std::to_string(last);
  rejections_.push_back("the PLC rejects " + doing + area_name(request.area) + which + ": " +
                        exception_text(code, request));
}

client::Identity ModbusDialog::identify(client::Fault& fault) {
  std::string found = "the PLC does not identify itself (function 43)";
  if (!mute_) {
    ClientReply reply;
    fault = transact({.kind = ClientRequest::Kind::identify}, {}, reply);
    mute_ = fault.kind == client::Fault::Kind::transport;  // some servers do not answer functions that they do not know
    if (fault) return {};
    const std::string text = identification_text(reply.data);
    if (!text.empty()) found = "the PLC is `" + text + "`";
  }
  std::array<std::vector<std::uint64_t>, kTables> words;
  for (std::size_t i = 0; i < kTables; ++i) {
    const auto table = static_cast<Table>(i);
    const bool bits = table == Table::coil || table == Table::discrete_input;
    words[i].resize(bits ? image::bit_words(sizes_[i]) : image::register_words(sizes_[i]));
  }
  fault = read_all(operations_, {words[0], words[2]});
  const bool operations = !fault;
  if (operations || fault.kind == client::Fault::Kind::rejected) fault = read_back(words[1], words[3]);
  if (fault.kind == client::Fault::Kind::rejected) fault = {};
  if (fault) mute_ = false;  // it is not function 43 that gets no answer
  return {.kind = client::Identity::Kind::unverifiable,
          .message = found + (operations ? "; its operations can be read" : "; its operations cannot be read") +
                     ", but Modbus has nothing to compare the map with"};
}

void ModbusDialog::retry_rejected() noexcept {
  for (Direction* direction : {&operations_, &events_}) {
    for (ReadRequest& one : direction->requests) one.skipped = false;
  }
}

/// Replaces a request over gaps by those without; false if it has none.
bool ModbusDialog::divide(Direction& direction, std::size_t index) {
  const ClientRequest request = direction.requests[index].request;
  const Items& items = direction.items[static_cast<std::size_t>(request.area)];
  const auto before = [](const AddressRange& item, std::uint32_t address) { return item.first < address; };
  const auto begin = std::lower_bound(items.begin(), items.end(), request.first, before);
  const auto end = std::lower_bound(begin, items.end(), std::uint32_t{request.first} + request.count, before);
  const auto exact = plan_ranges(std::span(begin, end), kMostBitsRead, false);
  if (exact.size() <= 1) return false;
  const auto at = direction.requests.begin() + static_cast<std::ptrdiff_t>(index);
  std::vector<ReadRequest> requests;
  requests.reserve(exact.size());
  for (const PlannedRange& one : exact) {
    requests.push_back({request_of(ClientRequest::Kind::read, request.area, one.range)});
  }
  direction.requests.insert(direction.requests.erase(at), requests.begin(), requests.end());
  return true;
}

client::Fault ModbusDialog::read_all(Direction& direction, const Words& out) {
  bool any = direction.requests.empty();
  for (std::size_t i = 0; i < direction.requests.size(); ++i) {
    if (direction.requests[i].skipped) continue;
    ClientRequest request = direction.requests[i].request;
    ClientReply reply;
    if (client::Fault fault = transact(request, {}, reply)) return fault;
    if (reply.exception == kIllegalAddress && divide(direction, i)) {
      request = direction.requests[i].request;
      if (client::Fault fault = transact(request, {}, reply)) return fault;
    }
    if (reply.exception == 0) {
      take(direction, reply, request, out);
      any = true;
      continue;
    }
    note_rejection(request, reply.exception);
    direction.requests[i].skipped = !is_busy(reply.exception);
  }
  return {any ? client::Fault::Kind::none : client::Fault::Kind::rejected};
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
    const std::uint16_t value = field(reply.data, std::size_t{2} * (address - request.first));
    image::set_register(words, address - placed.offset, packed ? in_order(value) : value);
  }
}

client::Fault ModbusDialog::read(image::Tables& tables) {
  return read_all(operations_, {tables.coils.words, tables.holding_registers.words});
}

client::Fault ModbusDialog::read_back(std::span<std::uint64_t> discrete_inputs,
                                      std::span<std::uint64_t> input_registers) {
  return read_all(events_, {discrete_inputs, input_registers});
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
      const std::uint16_t value = in_order(static_cast<std::uint16_t>(change.value & owned_[lane]));
      pieces_.push_back({{address, 1}, {value}});
      continue;
    }
    const bool joins = previous + 1 == lane && continues_[lane];
    if (!joins) pieces_.push_back({{address, 0}, {}});
    Piece& piece = pieces_.back();
    piece.values[piece.range.count++] = change.value;
    previous = lane;
  }
}

client::Fault ModbusDialog::write(std::span<const client::LaneChange> changes) {
  const auto begin_of_numbers = std::find_if(changes.begin(), changes.end(), [](const client::LaneChange& change) {
    return change.lane.table == Table::input_register;
  });
  const auto bits = changes.first(static_cast<std::size_t>(begin_of_numbers - changes.begin()));
  const auto numbers = changes.subspan(bits.size());
  const bool coils = !bits.empty() && has_bits(placement(Table::discrete_input).area);
  if (coils) {
    add_coils(bits);
    if (client::Fault fault = write_area(Area::coils, kMostBitsWritten)) return fault;
  }
  add_registers(coils ? numbers : changes);
  return write_area(Area::holding_registers, kMostRegistersWritten);
}

/// Writes the pieces and forgets them.
client::Fault ModbusDialog::write_area(Area area, std::uint32_t most) {
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
    const ClientRequest request = request_of(ClientRequest::Kind::write, area, planned.range);
    ClientReply reply;
    if (client::Fault fault = transact(request, std::span(values_).subspan(planned.item, planned.range.count), reply)) {
      return fault;
    }
    if (reply.exception != 0) note_rejection(request, reply.exception);
  }
  return {};
}

}  // namespace symplant::link::modbus
