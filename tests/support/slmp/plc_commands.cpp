// Executes device requests on a PLC's memory.
#include "support/slmp/plc_commands.hpp"

#include <algorithm>

#include "support/slmp/plc_fields.hpp"

namespace symplant::test::slmp {
namespace {

constexpr std::size_t kModelLength = 16;

/// Contacts and coils of timers and counters.
bool is_contact_or_coil(const DeviceType& device) {
  static constexpr std::array kNames = {"TS", "TC", "STS", "STC", "CS", "CC"};
  return std::find(kNames.begin(), kNames.end(), device.name) != kNames.end();
}

std::uint16_t refusal_of(const Item& item, const DeviceRequest& request, const Cpu& cpu, const PlcMemory& memory) {
  const std::uint32_t points = memory.points(*item.device);
  if (points == 0) return kDevice;
  const bool is_random = request.command == kReadRandom || request.command == kWriteRandom;
  if (is_random && item.width > 1 && is_contact_or_coil(*item.device)) return kDeviceNotInThisCommand;
  if (request.is_write && item.device->name == "S" && !cpu.profile.writes_steps) return kReadOnly;
  return std::uint64_t{item.number} + item.covered() > points ? cpu.profile.out_of_range : std::uint16_t{kOk};
}

void write_item(const Item& item, PlcMemory& memory) {
  if (item.width == 1) return memory.write_bits(*item.device, item.number, item.values);
  if (item.width == 16) return memory.write_words(*item.device, item.number, item.values);
  memory.write_words(*item.device, item.number, {item.values.front() & 0xFFFFU, item.values.front() >> 16U});
}

void read_item(const Item& item, const PlcMemory& memory, FieldWriter& reply) {
  std::vector<std::uint32_t> values;
  if (item.width == 1) {
    memory.read_bits(*item.device, item.number, item.points, values);
    return reply.bits(values);
  }
  memory.read_words(*item.device, item.number, item.width == 32 ? 2 : item.points, values);
  if (item.width == 16) return reply.words(values);
  reply.dwords({values[0] | values[1] << 16U});
}

std::uint16_t run_items(const DeviceRequest& request, const Cpu& cpu, PlcMemory& memory, FieldWriter& reply) {
  for (const Item& item : request.items) {
    const std::uint16_t refusal = refusal_of(item, request, cpu, memory);
    if (refusal != kOk) return refusal;
    if (request.is_write) {
      write_item(item, memory);
    } else {
      read_item(item, memory, reply);
    }
  }
  return kOk;
}

void write_model(const Cpu& cpu, FieldWriter& reply) {
  std::string name = cpu.model;
  name.resize(kModelLength, ' ');
  reply.text(name);
  reply.number(cpu.model_code, 2);
}

bool has_overlap(std::vector<DeviceRange> ranges) {
  std::sort(ranges.begin(), ranges.end(), [](const DeviceRange& a, const DeviceRange& b) {
    return a.device != b.device ? a.device < b.device : a.first < b.first;
  });
  return std::adjacent_find(ranges.begin(), ranges.end(), [](const DeviceRange& a, const DeviceRange& b) {
           return a.device == b.device && a.first + a.count > b.first;
         }) != ranges.end();
}

}  // namespace

Outcome execute(const RequestFrame& frame, const Cpu& cpu, PlcMemory& memory) {
  const DecodedRequest decoded = decode(frame, cpu.profile, cpu.code, cpu.has_octal_input_output);
  const DeviceRequest& request = decoded.request;
  Outcome outcome{};
  outcome.end_code = decoded.end_code;
  FieldWriter reply(cpu.code);
  if (outcome.end_code == kOk && frame.route != cpu.route) outcome.end_code = kOtherTarget;
  if (outcome.end_code == kOk && request.is_write && !cpu.accepts_writes) outcome.end_code = kNotInRun;
  if (outcome.end_code == kOk && frame.command == kReadModel) write_model(cpu, reply);
  if (outcome.end_code == kOk && frame.command == kLoopback) {
    reply.number(static_cast<std::uint32_t>(request.text.size()), 2);
    reply.text(request.text);
  }
  if (outcome.end_code == kOk) outcome.end_code = run_items(request, cpu, memory, reply);
  if (outcome.end_code == kOk) outcome.data = reply.bytes();

  LoggedRequest& log = outcome.log;
  log.is_4e = frame.is_4e;
  log.is_write = request.is_write;
  log.command = frame.command;
  log.subcommand = frame.subcommand;
  log.end_code = outcome.end_code;
  log.points = request.points;
  for (const Item& item : request.items) {
    if (item.device != nullptr) log.ranges.push_back({item.device->name, item.number, item.covered()});
  }
  outcome.has_duplicate = request.is_write && has_overlap(log.ranges);
  return outcome;
}

}  // namespace symplant::test::slmp
