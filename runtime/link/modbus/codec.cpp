// Answers to Modbus requests, by the Modbus Application Protocol V1.1b3, section 6.
#include "symplant/link/modbus/codec.hpp"

#include <algorithm>
#include <array>

#include "symplant/link/modbus/device_identification.hpp"
#include "symplant/link/modbus/fields.hpp"

namespace symplant::link::modbus {

namespace {

using Request = std::span<const std::uint8_t>;
using Reply = std::span<std::uint8_t, kMaxPdu>;

constexpr std::uint32_t kMaxReadBits = 2000;
constexpr std::uint32_t kMaxReadRegisters = 125;
constexpr std::uint32_t kMaxWriteBits = 1968;
constexpr std::uint32_t kMaxWriteRegisters = 123;
constexpr std::uint32_t kMaxReadWriteRegisters = 121;  ///< most that function 23 writes
constexpr std::uint8_t kFirstReserved = 0x80;          ///< function codes from here on mark exceptions in replies
constexpr std::uint16_t kCoilOn = 0xFF00;
constexpr std::uint16_t kCoilOff = 0x0000;

/// Size of a request of two 16-bit fields, and of the part of a multiple write before its data.
constexpr std::size_t kShortRequest = 5;
constexpr std::size_t kWriteHead = 6;
constexpr std::size_t kMaskRequest = 7;
constexpr std::size_t kReadWriteHead = 10;

Answer refuse(Request request, Reply reply, Exception exception) noexcept {
  reply[0] = static_cast<std::uint8_t>(request[0] | kFirstReserved);
  reply[1] = static_cast<std::uint8_t>(exception);
  return {.size = 2, .exception = exception};
}

/// The reply to a write: the request's first bytes.
Answer echo(Request request, Reply reply, Table table, std::uint16_t count) noexcept {
  std::copy_n(request.begin(), kShortRequest, reply.begin());
  return {.size = kShortRequest, .written = table, .first = field(request, 1), .count = count};
}

constexpr std::uint32_t bytes_of_bits(std::uint32_t bits) { return (bits + 7) / 8; }

/// Checks a request to read: exception 03 or 02, or no exception.
Exception check_read(Request request, std::uint32_t max, std::uint32_t size) noexcept {
  if (request.size() != kShortRequest) return Exception::illegal_data_value;
  const std::uint32_t quantity = field(request, 3);
  if (quantity == 0 || quantity > max) return Exception::illegal_data_value;
  return field(request, 1) + quantity > size ? Exception::illegal_data_address : Exception::none;
}

/// An answer with the range that was read.
Answer reported(std::size_t size, Table table, std::uint32_t first, std::uint32_t count) noexcept {
  return {.size = size,
          .read = table,
          .read_first = static_cast<std::uint16_t>(first),
          .read_count = static_cast<std::uint16_t>(count)};
}

Answer read_bits(Request request, Reply reply, Table table, TableView<const std::uint64_t> view) noexcept {
  const Exception fault = check_read(request, kMaxReadBits, view.size);
  if (fault != Exception::none) return refuse(request, reply, fault);
  const std::uint32_t first = field(request, 1);
  const std::uint32_t quantity = field(request, 3);
  const std::uint32_t bytes = bytes_of_bits(quantity);
  reply[0] = request[0];
  reply[1] = static_cast<std::uint8_t>(bytes);
  for (std::uint32_t done = 0; done < quantity; done += image::kBitsPerWord) {
    std::uint64_t bits = image::get_bits(view.words, first + done);
    if (quantity - done < image::kBitsPerWord) bits &= (std::uint64_t{1} << (quantity - done)) - 1;
    for (std::uint32_t i = done / 8; i < std::min(bytes, done / 8 + 8); ++i) {
      reply[2 + i] = static_cast<std::uint8_t>(bits);
      bits >>= 8;
    }
  }
  return reported(2 + bytes, table, first, quantity);
}

/// The registers of a table: `registers(address)` is the value of one.
template <class Registers>
Answer registers_from(std::uint32_t first, std::uint32_t quantity, Request request, Reply reply, Table table,
                      const Registers& registers) noexcept {
  reply[0] = request[0];
  reply[1] = static_cast<std::uint8_t>(2 * quantity);
  for (std::uint32_t i = 0; i < quantity; ++i) put_field(reply, 2 + 2 * i, registers(first + i));
  return reported(2 + 2 * quantity, table, first, quantity);
}

template <class Registers>
Answer read_registers(Request request, Reply reply, Table table, std::uint32_t size,
                      const Registers& registers) noexcept {
  const Exception fault = check_read(request, kMaxReadRegisters, size);
  if (fault != Exception::none) return refuse(request, reply, fault);
  return registers_from(field(request, 1), field(request, 3), request, reply, table, registers);
}

auto holding_registers_of(const Tables& tables) noexcept {
  return [words = tables.holding_registers.words](std::uint32_t address) { return image::get_lane(words, address); };
}

Answer read_coils(Request request, const Tables& tables, Reply reply) noexcept {
  return read_bits(request, reply, Table::coil, {tables.coils.words, tables.coils.size});
}

Answer read_discrete_inputs(Request request, const Tables& tables, Reply reply) noexcept {
  return read_bits(request, reply, Table::discrete_input, tables.discrete_inputs);
}

Answer read_holding_registers(Request request, const Tables& tables, Reply reply) noexcept {
  return read_registers(request, reply, Table::holding_register, tables.holding_registers.size,
                        holding_registers_of(tables));
}

Answer read_input_registers(Request request, const Tables& tables, Reply reply) noexcept {
  return read_registers(request, reply, Table::input_register, tables.input_registers.size(),
                        [&](std::uint32_t address) { return tables.input_registers[address]; });
}

Answer write_single_coil(Request request, const Tables& tables, Reply reply) noexcept {
  if (request.size() != kShortRequest) return refuse(request, reply, Exception::illegal_data_value);
  const std::uint16_t value = field(request, 3);
  if (value != kCoilOn && value != kCoilOff) return refuse(request, reply, Exception::illegal_data_value);
  const std::uint16_t address = field(request, 1);
  if (address >= tables.coils.size) return refuse(request, reply, Exception::illegal_data_address);
  image::set_bit(tables.coils.words, address, value == kCoilOn);
  return echo(request, reply, Table::coil, 1);
}

Answer write_single_register(Request request, const Tables& tables, Reply reply) noexcept {
  if (request.size() != kShortRequest) return refuse(request, reply, Exception::illegal_data_value);
  const std::uint16_t address = field(request, 1);
  if (address >= tables.holding_registers.size) return refuse(request, reply, Exception::illegal_data_address);
  image::set_lane(tables.holding_registers.words, address, field(request, 3));
  return echo(request, reply, Table::holding_register, 1);
}

/// Checks a request to write several addresses, whose data take `bytes(quantity)`: exception 03 or 02, or none.
Exception check_write(Request request, std::uint32_t max, std::uint32_t (*bytes)(std::uint32_t),
                      std::uint32_t size) noexcept {
  if (request.size() < kWriteHead) return Exception::illegal_data_value;
  const std::uint32_t quantity = field(request, 3);
  const std::uint32_t count = request[5];
  if (quantity == 0 || quantity > max || count != bytes(quantity)) return Exception::illegal_data_value;
  if (request.size() != kWriteHead + count) return Exception::illegal_data_value;
  return field(request, 1) + quantity > size ? Exception::illegal_data_address : Exception::none;
}

Answer write_coils(Request request, const Tables& tables, Reply reply) noexcept {
  const Exception fault = check_write(request, kMaxWriteBits, bytes_of_bits, tables.coils.size);
  if (fault != Exception::none) return refuse(request, reply, fault);
  const std::uint32_t first = field(request, 1);
  const std::uint16_t quantity = field(request, 3);
  const Request data = request.subspan(kWriteHead);
  for (std::uint32_t done = 0; done < quantity; done += image::kBitsPerWord) {
    const std::uint32_t count = std::min(image::kBitsPerWord, quantity - done);
    std::uint64_t bits = 0;
    for (std::uint32_t i = bytes_of_bits(count); i > 0; --i) bits = bits << 8 | data[done / 8 + i - 1];
    image::set_bits(tables.coils.words, first + done, bits, count);
  }
  return echo(request, reply, Table::coil, quantity);
}

void put_registers(Request data, std::uint32_t first, std::uint32_t quantity, const Tables& tables) noexcept {
  for (std::uint32_t i = 0; i < quantity; ++i) {
    image::set_lane(tables.holding_registers.words, first + i, field(data, 2 * std::size_t{i}));
  }
}

Answer write_registers(Request request, const Tables& tables, Reply reply) noexcept {
  constexpr auto kBytes = [](std::uint32_t registers) { return 2 * registers; };
  const Exception fault = check_write(request, kMaxWriteRegisters, kBytes, tables.holding_registers.size);
  if (fault != Exception::none) return refuse(request, reply, fault);
  const std::uint32_t first = field(request, 1);
  const std::uint16_t quantity = field(request, 3);
  put_registers(request.subspan(kWriteHead), first, quantity, tables);
  return echo(request, reply, Table::holding_register, quantity);
}

Answer mask_write_register(Request request, const Tables& tables, Reply reply) noexcept {
  if (request.size() < 3) return refuse(request, reply, Exception::illegal_data_value);
  // The only function whose diagram checks the address first (section 6.16).
  const std::uint16_t address = field(request, 1);
  if (address >= tables.holding_registers.size) return refuse(request, reply, Exception::illegal_data_address);
  if (request.size() != kMaskRequest) return refuse(request, reply, Exception::illegal_data_value);
  const std::uint32_t kept = field(request, 3);
  const std::uint32_t set = field(request, 5);
  const std::uint32_t now = image::get_lane(tables.holding_registers.words, address);
  image::set_lane(tables.holding_registers.words, address, static_cast<std::uint16_t>((now & kept) | (set & ~kept)));
  std::copy_n(request.begin(), kMaskRequest, reply.begin());
  return {.size = kMaskRequest, .written = Table::holding_register, .first = address, .count = 1};
}

/// Checks a request to read and write registers: exception 03 or 02, or no exception.
Exception check_read_write(Request request, std::uint32_t size) noexcept {
  if (request.size() < kReadWriteHead) return Exception::illegal_data_value;
  const std::uint32_t read = field(request, 3);
  const std::uint32_t written = field(request, 7);
  const std::uint32_t count = request[9];
  if (read == 0 || read > kMaxReadRegisters || written == 0 || written > kMaxReadWriteRegisters) {
    return Exception::illegal_data_value;
  }
  if (count != 2 * written || request.size() != kReadWriteHead + count) return Exception::illegal_data_value;
  const bool within = field(request, 1) + read <= size && field(request, 5) + written <= size;
  return within ? Exception::none : Exception::illegal_data_address;
}

Answer read_write_registers(Request request, const Tables& tables, Reply reply) noexcept {
  const Exception fault = check_read_write(request, tables.holding_registers.size);
  if (fault != Exception::none) return refuse(request, reply, fault);
  const std::uint16_t first = field(request, 5);
  const std::uint16_t quantity = field(request, 7);
  put_registers(request.subspan(kReadWriteHead), first, quantity, tables);
  Answer answer = registers_from(field(request, 1), field(request, 3), request, reply, Table::holding_register,
                                 holding_registers_of(tables));
  answer.written = Table::holding_register;
  answer.first = first;
  answer.count = quantity;
  return answer;
}

/// A function code and the function that answers it.
struct Function {
  std::uint8_t code;
  Answer (*answer)(Request request, const Tables& tables, Reply reply) noexcept;
};

constexpr std::array kFunctions = {
    Function{1, read_coils},
    Function{2, read_discrete_inputs},
    Function{3, read_holding_registers},
    Function{4, read_input_registers},
    Function{5, write_single_coil},
    Function{6, write_single_register},
    Function{15, write_coils},
    Function{16, write_registers},
    Function{22, mask_write_register},
    Function{23, read_write_registers},
};

bool gets_no_reply(Request request) noexcept { return request.empty() || request[0] >= kFirstReserved; }

}  // namespace

Answer answer_request(Request request, const Tables& tables, const Identity& identity, Reply reply) noexcept {
  if (gets_no_reply(request)) return {};
  if (request[0] == kEncapsulatedInterface) {
    const Identified identified = identify(request, identity, reply);
    if (identified.exception != Exception::none) return refuse(request, reply, identified.exception);
    return {.size = identified.size};
  }
  for (const Function& function : kFunctions) {
    if (function.code == request[0]) return function.answer(request, tables, reply);
  }
  return refuse(request, reply, Exception::illegal_function);
}

Answer refuse_request(Request request, Exception exception, Reply reply) noexcept {
  return gets_no_reply(request) ? Answer{} : refuse(request, reply, exception);
}

}  // namespace symplant::link::modbus
