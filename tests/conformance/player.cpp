// Plays a row: sets memory, plays steps or cells, compares memory.
#include "player.hpp"

#include <algorithm>

namespace symplant::conformance {

namespace {

constexpr std::uint32_t kBitsAtOnce = 1968;
constexpr std::uint32_t kRegistersAtOnce = 120;

void put(Bytes& bytes, std::uint32_t value) {
  bytes.push_back(static_cast<std::uint8_t>(value >> 8));
  bytes.push_back(static_cast<std::uint8_t>(value & 0xFF));
}

Bytes head_of(std::uint8_t function, std::uint32_t first, std::uint32_t count) {
  Bytes bytes = {function};
  put(bytes, first);
  put(bytes, count);
  return bytes;
}

Bytes bits_of(const std::vector<bool>& bits, std::uint32_t first, std::uint32_t count) {
  Bytes bytes((count + 7) / 8, 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (bits[first + i]) bytes[i / 8] = static_cast<std::uint8_t>(bytes[i / 8] | 1U << (i % 8));
  }
  return bytes;
}

Bytes registers_of(const std::vector<std::uint16_t>& registers, std::uint32_t first, std::uint32_t count) {
  Bytes bytes;
  for (std::uint32_t i = 0; i < count; ++i) put(bytes, registers[first + i]);
  return bytes;
}

Bytes with_data(Bytes head, const Bytes& data) {
  head.push_back(static_cast<std::uint8_t>(data.size()));
  head.insert(head.end(), data.begin(), data.end());
  return head;
}

/// The memory contents, read in pieces that fit one request.
std::string compare_table(test::RawClient& client, std::uint8_t function, std::uint32_t size, std::uint32_t at_once,
                          const auto& data_of) {
  for (std::uint32_t first = 0; first < size; first += at_once) {
    const std::uint32_t count = std::min(at_once, size - first);
    const Bytes seen = client.ask(head_of(function, first, count));
    if (seen.empty()) return "afterwards no answer";
    if (seen != with_data({function}, data_of(first, count))) {
      return function == 1 ? "coils changed" : "registers changed";
    }
  }
  return {};
}

Result play_cells(const Row& row, const Server& server) {
  Result result{.of = static_cast<int>(row.cells.size()), .seen = {}};
  for (const auto& [value, expected] : row.cells) {
    Memory memory(server.sizes);
    const Memory before = memory;
    if (!fill(server, memory)) return result.seen = "the server does not answer", result;
    const Cell cell = cell_of(row, value, server.sizes, memory);
    test::RawClient client = connect_to(server);
    client.send(test::RawClient::frame(1, cell.request));
    const Seen seen = next_frame(client);
    std::vector<std::string> allowed = split(expected, "/");
    if (server.strict) allowed.resize(1);
    const bool good = std::any_of(allowed.begin(), allowed.end(), [&](const std::string& one) {
      const Bytes wanted = one == "ok" ? cell.answer
                                       : Bytes{static_cast<std::uint8_t>(cell.request[0] | 0x80),
                                               static_cast<std::uint8_t>(std::stoi(one))};
      return seen.kind == Seen::Kind::frame && seen.transaction == 1 && seen.pdu == wanted;
    });
    std::string fault = good ? compare(server, expected == "ok" ? memory : before) : seen.text();
    if (fault.empty()) {
      ++result.passed;
    } else if (result.seen.empty()) {
      result.seen = std::to_string(value) + ": " + fault;
    }
  }
  return result;
}

}  // namespace

Memory::Memory(const Sizes& sizes) : coils(sizes[0]), registers(sizes[2]) {
  for (std::size_t i = 0; i < coils.size(); ++i) coils[i] = i % 3 == 0;
  for (std::size_t i = 0; i < registers.size(); ++i) registers[i] = static_cast<std::uint16_t>(7 * i + 1);
}

std::string Seen::text() const {
  switch (kind) {
    case Kind::frame:
      return hex(pdu);
    case Kind::closed:
      return "closed";
    case Kind::garbled:
      return "no frame";
    case Kind::nothing:
      break;
  }
  return "no answer";
}

Seen next_frame(const test::RawClient& client) {
  const Bytes header = client.receive(7);
  if (header.size() != 7) {
    return {.kind = header.empty() && client.is_closed() ? Seen::Kind::closed : Seen::Kind::nothing, .pdu = {}};
  }
  const std::size_t length = static_cast<std::size_t>(header[4] << 8 | header[5]);
  if (header[2] != 0 || header[3] != 0 || length < 2 || length > 254) {
    return {.kind = Seen::Kind::garbled, .pdu = {}};
  }
  Seen seen{.kind = Seen::Kind::frame, .transaction = header[0] << 8 | header[1], .unit = header[6], .pdu = {}};
  seen.pdu = client.receive(length - 1);
  if (seen.pdu.size() != length - 1) seen.kind = Seen::Kind::garbled;
  return seen;
}

test::RawClient connect_to(const Server& server) {
  test::RawClient client(server.port);
  client.wait_at_most(server.patience);
  return client;
}

bool fill(const Server& server, const Memory& memory) {
  test::RawClient client = connect_to(server);
  for (std::uint32_t first = 0; first < server.sizes[0]; first += kBitsAtOnce) {
    const std::uint32_t count = std::min(kBitsAtOnce, server.sizes[0] - first);
    const Bytes head = head_of(15, first, count);
    if (client.ask(with_data(head, bits_of(memory.coils, first, count))) != head) return false;
  }
  for (std::uint32_t first = 0; first < server.sizes[2]; first += kRegistersAtOnce) {
    const std::uint32_t count = std::min(kRegistersAtOnce, server.sizes[2] - first);
    const Bytes head = head_of(16, first, count);
    if (client.ask(with_data(head, registers_of(memory.registers, first, count))) != head) return false;
  }
  return true;
}

std::string compare(const Server& server, const Memory& memory) {
  test::RawClient client = connect_to(server);
  std::string fault =
      compare_table(client, 1, server.sizes[0], kBitsAtOnce,
                    [&](std::uint32_t first, std::uint32_t count) { return bits_of(memory.coils, first, count); });
  if (!fault.empty()) return fault;
  return compare_table(client, 3, server.sizes[2], kRegistersAtOnce, [&](std::uint32_t first, std::uint32_t count) {
    return registers_of(memory.registers, first, count);
  });
}

Cell cell_of(const Row& row, std::uint32_t value, const Sizes& sizes, Memory& memory) {
  const std::uint32_t first = address_of(row.address, sizes);
  const auto function = static_cast<std::uint8_t>(row.function);
  const Bytes head = head_of(function, first, value);
  const auto good = [&](std::uint32_t size, std::uint32_t count) { return count > 0 && first + count <= size; };
  Cell cell{head, {}};
  if (function <= 2) {
    std::vector<bool> inputs(sizes[1]);
    for (std::uint32_t i = 0; i < inputs.size(); ++i) inputs[i] = Memory::discrete(i);
    const std::vector<bool>& bits = function == 1 ? memory.coils : inputs;
    if (good(sizes[function - 1U], value)) cell.answer = with_data({function}, bits_of(bits, first, value));
  } else if (function <= 4) {
    std::vector<std::uint16_t> inputs(sizes[3]);
    for (std::uint32_t i = 0; i < inputs.size(); ++i) inputs[i] = Memory::input(i);
    const std::vector<std::uint16_t>& registers = function == 3 ? memory.registers : inputs;
    if (good(sizes[function - 1U], value)) cell.answer = with_data({function}, registers_of(registers, first, value));
  } else if (function == 5 || function == 6) {
    cell.answer = head;
    if (function == 5 && good(sizes[0], 1)) memory.coils[first] = value != 0;
    if (function == 6 && good(sizes[2], 1)) memory.registers[first] = static_cast<std::uint16_t>(value);
  } else {
    // Beyond the limit the data are those of the limit, so that frames stay valid and only the quantity is wrong.
    const bool write = function != 0x17 || row.write_part;
    const std::uint32_t limit = function == 0x0F ? 246 : function == 0x10 ? 246 : 242;
    const std::uint32_t needed = function == 0x0F ? (value + 7) / 8 : 2 * value;
    Bytes data;
    for (std::uint32_t i = 0; i < std::min(needed, limit); ++i) data.push_back(static_cast<std::uint8_t>(0xA7 + i));
    if (!write) data = {0xBE, 0xEF};
    const std::uint32_t target = write ? first : 0;
    const std::uint32_t count = write ? value : 1;
    if (function == 0x0F && good(sizes[0], value)) {
      for (std::uint32_t i = 0; i < value && i / 8 < data.size(); ++i)
        memory.coils[first + i] = (data[i / 8] >> (i % 8) & 1) != 0;
    } else if (function != 0x0F && target + count <= sizes[2]) {
      for (std::uint32_t i = 0; i < count && 2 * i + 1 < data.size(); ++i) {
        memory.registers[target + i] = static_cast<std::uint16_t>(data[2 * i] << 8 | data[2 * i + 1]);
      }
    }
    cell.answer = head;
    if (function == 0x17) {
      cell.request = head_of(function, write ? 0 : first, write ? 1 : value);
      put(cell.request, target);
      put(cell.request, count);
      const std::uint32_t read = write ? 0 : first;
      const std::uint32_t quantity = write ? 1 : value;
      if (read + quantity <= sizes[2]) {
        cell.answer = with_data({function}, registers_of(memory.registers, read, quantity));
      }
    }
    cell.request = with_data(cell.request, data);
  }
  return cell;
}

Result play(const Row& row, const Server& server) {
  if (row.function != 0) return play_cells(row, server);
  Memory memory(server.sizes);
  Result result;
  if (!fill(server, memory)) return result.seen = "the server does not answer", result;
  result.seen = play_steps(row, server, memory);
  if (result.seen.empty()) result.seen = compare(server, memory);
  result.passed = result.seen.empty() ? 1 : 0;
  return result;
}

}  // namespace symplant::conformance
