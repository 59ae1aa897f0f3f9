// The answers of a PLC that serves Modbus.
#include "support/modbus/plc_answers.hpp"

#include <utility>

namespace symplant::test::modbus {

namespace {

std::size_t word_at(const Bytes& bytes, std::size_t at) {
  return static_cast<std::size_t>(bytes[at]) * 256 + bytes[at + 1];
}

void append_word(Bytes& bytes, std::size_t value) {
  bytes.push_back(static_cast<std::uint8_t>(value / 256 % 256));
  bytes.push_back(static_cast<std::uint8_t>(value % 256));
}

PlcAnswer exception(const Bytes& request, std::uint8_t code) {
  return {{static_cast<std::uint8_t>(request[0] + 128), code}, {}};
}

bool exists(PlcMemory& memory, PlcArea area, std::size_t first, std::size_t count) {
  if (first + count > memory.of(area).size()) return false;
  for (std::size_t i = first; i < first + count; ++i) {
    if (memory.holes.count({area, i}) != 0) return false;
  }
  return true;
}

PlcAnswer read(const Bytes& request, PlcMemory& memory, const PlcAbilities& abilities) {
  if (request.size() != 5) return exception(request, 3);
  const auto area = static_cast<PlcArea>(request[0]);
  const bool bits = area == PlcArea::coils || area == PlcArea::discrete_inputs;
  const std::size_t first = word_at(request, 1);
  const std::size_t count = word_at(request, 3);
  if (count == 0 || count > (bits ? 2000 : abilities.most_registers)) return exception(request, 3);
  if (!exists(memory, area, first, count)) return exception(request, 2);
  const auto& values = memory.of(area);
  Bytes reply = {request[0], static_cast<std::uint8_t>(bits ? (count + 7) / 8 : 2 * count)};
  if (bits) reply.resize(2 + (count + 7) / 8);
  for (std::size_t i = 0; i < count; ++i) {
    if (!bits) {
      append_word(reply, values[first + i]);
    } else if (values[first + i] != 0) {
      reply[2 + i / 8] = static_cast<std::uint8_t>(reply[2 + i / 8] + (1U << i % 8));
    }
  }
  return {reply, {}};
}

PlcAnswer write(const Bytes& request, PlcMemory& memory) {
  const bool bits = request[0] == 15;
  const PlcArea area = bits ? PlcArea::coils : PlcArea::holding_registers;
  if (request.size() < 7) return exception(request, 3);
  const std::size_t first = word_at(request, 1);
  const std::size_t count = word_at(request, 3);
  const std::size_t size = bits ? (count + 7) / 8 : 2 * count;
  const bool counts = count != 0 && count <= (bits ? 1968 : 123) && request[5] == size && request.size() == 6 + size;
  if (!counts) return exception(request, 3);
  if (!exists(memory, area, first, count)) return exception(request, 2);
  Written written{area, first, {}};
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t value = bits ? (request[6 + i / 8] >> i % 8) % 2U : word_at(request, 6 + 2 * i);
    written.values.push_back(static_cast<std::uint16_t>(value));
    memory.of(area)[first + i] = static_cast<std::uint16_t>(value);
  }
  return {Bytes(request.begin(), request.begin() + 5), {std::move(written)}};
}

PlcAnswer write_one(const Bytes& request, PlcMemory& memory) {
  const bool bits = request[0] == 5;
  const PlcArea area = bits ? PlcArea::coils : PlcArea::holding_registers;
  if (request.size() != 5) return exception(request, 3);
  const std::size_t first = word_at(request, 1);
  const std::size_t value = word_at(request, 3);
  if (bits && value != 0 && value != 0xFF00) return exception(request, 3);
  if (!exists(memory, area, first, 1)) return exception(request, 2);
  const auto stored = static_cast<std::uint16_t>(bits ? value / 0xFF00 : value);
  memory.of(area)[first] = stored;
  return {request, {{area, first, {stored}}}};
}

PlcAnswer identify(const Bytes& request, const PlcAbilities& abilities) {
  if (request.size() != 4 || request[1] != 14) return exception(request, 1);
  if (request[2] != 1) return exception(request, 3);
  Bytes reply = {43, 14, 1, 1, 0, 0, 1, 0, static_cast<std::uint8_t>(abilities.vendor.size())};
  reply.insert(reply.end(), abilities.vendor.begin(), abilities.vendor.end());
  return {reply, {}};
}

}  // namespace

std::vector<std::uint16_t>& PlcMemory::of(PlcArea area) {
  switch (area) {
    case PlcArea::coils:
      return coils;
    case PlcArea::discrete_inputs:
      return discrete_inputs;
    case PlcArea::holding_registers:
      return holding_registers;
    case PlcArea::input_registers:
      break;
  }
  return input_registers;
}

PlcAnswer answer_of(const Bytes& request, PlcMemory& memory, PlcAbilities& abilities) {
  const int function = request[0];
  if (abilities.silent_functions.count(function) != 0) return {};
  if (abilities.functions.count(function) == 0) return exception(request, 1);
  if (!abilities.exceptions.empty()) {
    const std::uint8_t code = abilities.exceptions.front();
    abilities.exceptions.pop_front();
    return exception(request, code);
  }
  if (abilities.busy > 0) {
    --abilities.busy;
    return exception(request, 6);
  }
  if (function <= 4) return read(request, memory, abilities);
  if (function == 5 || function == 6) return write_one(request, memory);
  if (function == 43) return identify(request, abilities);
  return write(request, memory);
}

}  // namespace symplant::test::modbus
