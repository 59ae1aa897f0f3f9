// The conversation with a PLC that is a Modbus TCP server.
#include "symplant/link/modbus/client_dialog.hpp"

#include <algorithm>
#include <array>

#include "symplant/link/client/parts.hpp"
#include "symplant/link/image/words.hpp"
#include "symplant/link/modbus/client_map.hpp"
#include "symplant/link/modbus/fields.hpp"

namespace symplant::link::modbus {

namespace {

constexpr std::uint8_t kIllegalAddress = 2;
constexpr std::uint16_t kWholeLane = 0xFFFF;

std::uint16_t reversed(std::uint16_t bits) noexcept {
  std::uint32_t value = bits;
  value = (value >> 1 & 0x5555) | (value & 0x5555) << 1;
  value = (value >> 2 & 0x3333) | (value & 0x3333) << 2;
  value = (value >> 4 & 0x0F0F) | (value & 0x0F0F) << 4;
  return static_cast<std::uint16_t>(value >> 8 | value << 8);
}

}  // namespace

ModbusDialog::ModbusDialog(const ClientSettings& settings, const IoMap& map, const image::Map& placed)
    : settings_(settings),
      sizes_(map.sizes),
      owned_((sizes_[static_cast<std::size_t>(Table::discrete_input)] + kBitsInRegister - 1) / kBitsInRegister),
      continues_(sizes_[static_cast<std::size_t>(Table::input_register)]),
      registers_(std::size_t{image::kLanesPerWord} * placed.size(Plane::event_numbers)),
      exchange_(settings) {
  for (Direction* const direction : {&operations_, &events_}) {
    direction->lanes = lanes_of(map, placed, direction->numbers);
    add_items(*direction, map);
    plan_reads(*direction);
  }
  for (const IoPoint& point : map.points) {
    if (point.table == Table::discrete_input) {
      std::uint16_t& mask = owned_[point.number / kBitsInRegister];
      mask = static_cast<std::uint16_t>(mask | 1U << (point.number % kBitsInRegister));
    } else if (point.table == Table::input_register) {
      for (std::uint32_t number = point.number + 1; number <= point.last(); ++number) continues_[number] = true;
    }
  }
  for (std::uint32_t k = 1; map.status_block && k < kStatusWords; ++k) continues_[*map.status_block + k] = true;
  for (std::uint32_t number = 0; number < events_.lanes.size(); ++number) {
    if (events_.lanes[number] != kNoLane) registers_[events_.lanes[number]] = number;
  }
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
    items_of(Table::input_register).push_back({first, kStatusWords});
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
  struct Memory {
    std::vector<std::uint64_t> bits;
    std::vector<std::uint64_t> numbers;
  };
  const auto memory_of = [this](const Direction& direction) {
    return Memory{std::vector<std::uint64_t>(image::bit_words(sizes_[static_cast<std::size_t>(direction.bits)])),
                  std::vector<std::uint64_t>(direction.lanes.size())};
  };
  Memory memory = memory_of(operations_);
  fault = read({memory.bits, memory.numbers}, 0);
  const bool operations = !fault;
  memory = memory_of(events_);
  if (operations || fault.kind == client::Fault::Kind::rejected) fault = read_back({memory.bits, memory.numbers}, 0);
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
      if (dialog_.observer_ != nullptr) dialog_.report(direction_, request);
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

  std::vector<ClientRequest> parts(const ClientRequest& request, client::Answer answer) const {
    if (answer == client::Answer::over_gaps) return exact(request);
    const auto items = items_in(direction_, request);
    if (items.size() < 2) return {};
    std::vector<ClientRequest> halves = requests(request.area, items.first(items.size() / 2), true);
    const auto others = requests(request.area, items.subspan(items.size() / 2), true);
    halves.insert(halves.end(), others.begin(), others.end());
    return halves;
  }

  /// Events are not left out because they cannot be read back.
  void leave_out(const ClientRequest& request) {
    if (direction_.bits == Table::coil) dialog_.leave_out(direction_, request);
  }

 private:
  /// Without addresses between the items.
  std::vector<ClientRequest> exact(const ClientRequest& request) const {
    return requests(request.area, items_in(direction_, request), false);
  }

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
      client::Lane lane{plane_of(table), bits ? number / kBitsInRegister : number};
      if (table == direction.numbers) {
        if (number >= direction.lanes.size() || direction.lanes[number] == kNoLane) continue;
        lane.number = direction.lanes[number];
      }
      const auto mask = static_cast<std::uint16_t>(bits ? 1U << (number % kBitsInRegister) : kWholeLane);
      left_out_.push_back({{lane, mask, 0}, refusal_});
    }
  }
}

/// Copies all bits of a reply, since nothing looks at addresses without a symbol.
void ModbusDialog::take(const Direction& direction, const ClientReply& reply, const ClientRequest& request,
                        const Words& out) const {
  const auto& bits = settings_.placements[static_cast<std::size_t>(direction.bits)];
  const auto& numbers = settings_.placements[static_cast<std::size_t>(direction.numbers)];
  if (has_bits(request.area)) return copy_bits(reply.data, request.count, out.bits, request.first - bits->offset);
  if (bits && bits->area == request.area) take_packed(direction.bits, reply, request, out.bits);
  if (numbers && numbers->area == request.area) take_numbers(direction, reply, request, out.numbers);
}

/// Marks what a request has read by taking an answer in which all bits are set.
void ModbusDialog::report(const Direction& direction, const ClientRequest& request) {
  static constexpr auto kOnes = [] {
    std::array<std::uint8_t, kMaxFrame> ones{};
    ones.fill(0xFF);
    return ones;
  }();
  take(direction, ClientReply{.data = kOnes}, request, observer_->marks());
  observer_->answered(exchange_.sent(), exchange_.answered());
}

/// The addresses of a request that belong to a table in registers.
AddressRange ModbusDialog::registers_in(Table table, const ClientRequest& request) const {
  const Placement& placed = placement(table);
  const std::uint32_t size = sizes_[static_cast<std::size_t>(table)];
  const std::uint32_t registers = is_packed(placed, table) ? (size + kBitsInRegister - 1) / kBitsInRegister : size;
  const std::uint32_t first = std::max<std::uint32_t>(request.first, placed.offset);
  const std::uint32_t end = std::min(std::uint32_t{request.first} + request.count, placed.offset + registers);
  return {first, end < first ? 0 : end - first};
}

void ModbusDialog::take_packed(Table table, const ClientReply& reply, const ClientRequest& request,
                               std::span<std::uint64_t> bits) const {
  const AddressRange range = registers_in(table, request);
  for (std::uint32_t address = range.first; address < range.end(); ++address) {
    const std::uint16_t value = on_wire(field(reply.data, std::size_t{2} * (address - request.first)));
    image::set_lane(bits, address - placement(table).offset, in_order(value));
  }
}

void ModbusDialog::take_numbers(const Direction& direction, const ClientReply& reply, const ClientRequest& request,
                                std::span<std::uint64_t> numbers) const {
  const AddressRange range = registers_in(direction.numbers, request);
  for (std::uint32_t address = range.first; address < range.end(); ++address) {
    const std::uint32_t lane = direction.lanes[address - placement(direction.numbers).offset];
    if (lane == kNoLane) continue;
    image::set_lane(numbers, lane, on_wire(field(reply.data, std::size_t{2} * (address - request.first))));
  }
}

client::Fault ModbusDialog::read(const Words& operations, tables::Time now) {
  return read_all(operations_, operations, now);
}

client::Fault ModbusDialog::read_back(const Words& events, tables::Time now) { return read_all(events_, events, now); }

/// A register as the link has it, from the one of the protocol, or the other direction.
std::uint16_t ModbusDialog::on_wire(std::uint16_t value) const noexcept {
  if (settings_.byte_order == ByteOrder::high_first) return value;
  return static_cast<std::uint16_t>(value << 8 | value >> 8);
}

std::uint16_t ModbusDialog::in_order(std::uint16_t bits) const noexcept {
  return settings_.bit_order == BitOrder::low_first ? bits : reversed(bits);
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
