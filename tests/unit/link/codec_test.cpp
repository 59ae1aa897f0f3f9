// The table of function codes: each limit at its boundaries, against each place where an address may stand.
//
// The expected answer is worked out here from the specification's rows, on tables kept a place an element.
#include "symplant/link/modbus/codec.hpp"

#include <algorithm>
#include <initializer_list>
#include <random>
#include <vector>

#include "support/catch.hpp"

using namespace symplant;
using namespace symplant::link::modbus;
using Bytes = std::vector<std::uint8_t>;

namespace {

/// A server's memory, filled with what tells one place from another.
struct Memory {
  std::vector<std::uint64_t> coils, discrete, holding, input;
  std::array<std::uint32_t, 4> sizes;

  explicit Memory(std::uint32_t bits, std::uint32_t registers)
      : coils(bit_words(bits)),
        discrete(bit_words(bits)),
        holding(register_words(registers)),
        input(register_words(registers)),
        sizes{bits, bits, registers, registers} {
    for (std::uint32_t i = 0; i < bits; ++i) {
      set_bit(coils, i, i % 3 == 0);
      set_bit(discrete, i, i % 5 < 2);
    }
    for (std::uint32_t i = 0; i < registers; ++i) {
      set_register(holding, i, static_cast<std::uint16_t>(i * 7 + 1));
      set_register(input, i, static_cast<std::uint16_t>(0xF000 + i));
    }
  }

  Tables tables() { return {{coils, sizes[0]}, {discrete, sizes[1]}, {holding, sizes[2]}, {input, sizes[3]}}; }
  bool operator==(const Memory&) const = default;
};

void put(Bytes& bytes, std::uint32_t value) {
  bytes.push_back(static_cast<std::uint8_t>(value >> 8));
  bytes.push_back(static_cast<std::uint8_t>(value & 0xFF));
}

Bytes request(std::uint8_t code, std::initializer_list<std::uint32_t> fields) {
  Bytes bytes = {code};
  for (const std::uint32_t field : fields) put(bytes, field);
  return bytes;
}

struct Reply {
  Bytes bytes;
  Answer answer;
};

Reply ask(Memory& memory, const Bytes& bytes) {
  std::array<std::uint8_t, kMaxPdu> reply{};
  const Answer answer = answer_request(bytes, memory.tables(), reply);
  return {Bytes(reply.begin(), reply.begin() + static_cast<std::ptrdiff_t>(answer.size)), answer};
}

/// Demands an exception, and that nothing else has changed.
void check_refused(Memory& memory, const Bytes& bytes, int exception) {
  const Memory before = memory;
  const Reply reply = ask(memory, bytes);
  CHECK(reply.bytes == Bytes{static_cast<std::uint8_t>(bytes[0] | 0x80), static_cast<std::uint8_t>(exception)});
  CHECK(static_cast<int>(reply.answer.exception) == exception);
  CHECK(reply.answer.count == 0);
  CHECK(memory == before);
}

std::vector<std::uint32_t> quantities(std::uint32_t max) { return {0, 1, max - 1, max, max + 1, 0xFFFF}; }
std::vector<std::uint32_t> addresses(std::uint32_t size) { return {0, size - 1, size, 0xFFFF}; }

/// What a request for `quantity` places from `address` must be answered with: 0 for good.
int expected_exception(std::uint32_t address, std::uint32_t quantity, std::uint32_t max, std::uint32_t size) {
  if (quantity == 0 || quantity > max) return 3;
  return address + quantity > size ? 2 : 0;
}

constexpr std::uint32_t kBits = 2016;
constexpr std::uint32_t kRegisters = 160;

}  // namespace

TEST_CASE("reading bits (01, 02) at every boundary") {
  Memory memory(kBits, kRegisters);
  for (const std::uint8_t code : {std::uint8_t{1}, std::uint8_t{2}}) {
    for (const std::uint32_t address : addresses(kBits)) {
      for (const std::uint32_t quantity : quantities(2000)) {
        CAPTURE(code, address, quantity);
        const Bytes bytes = request(code, {address, quantity});
        const int exception = expected_exception(address, quantity, 2000, kBits);
        if (exception != 0) {
          check_refused(memory, bytes, exception);
          continue;
        }
        Bytes expected = {code, static_cast<std::uint8_t>((quantity + 7) / 8)};
        expected.resize(2 + (quantity + 7) / 8, 0);
        for (std::uint32_t i = 0; i < quantity; ++i) {
          const std::uint32_t place = address + i;
          const bool on = code == 1 ? place % 3 == 0 : place % 5 < 2;
          if (on) expected[2 + i / 8] = static_cast<std::uint8_t>(expected[2 + i / 8] | 1U << (i % 8));
        }
        CHECK(ask(memory, bytes).bytes == expected);
      }
    }
  }
}

TEST_CASE("reading registers (03, 04) at every boundary") {
  Memory memory(kBits, kRegisters);
  for (const std::uint8_t code : {std::uint8_t{3}, std::uint8_t{4}}) {
    for (const std::uint32_t address : addresses(kRegisters)) {
      for (const std::uint32_t quantity : quantities(125)) {
        CAPTURE(code, address, quantity);
        const Bytes bytes = request(code, {address, quantity});
        const int exception = expected_exception(address, quantity, 125, kRegisters);
        if (exception != 0) {
          check_refused(memory, bytes, exception);
          continue;
        }
        Bytes expected = {code, static_cast<std::uint8_t>(2 * quantity)};
        for (std::uint32_t i = 0; i < quantity; ++i) {
          put(expected, code == 3 ? (address + i) * 7 + 1 : 0xF000 + address + i);
        }
        CHECK(ask(memory, bytes).bytes == expected);
      }
    }
  }
}

TEST_CASE("writing one coil (05): the value is checked before the address") {
  Memory memory(kBits, kRegisters);
  for (const std::uint32_t address : addresses(kBits)) {
    for (const std::uint32_t value : {0x0000U, 0xFF00U, 0x0001U, 0x00FFU, 0xFF01U, 0xFFFFU, 0x0100U}) {
      CAPTURE(address, value);
      const Bytes bytes = request(5, {address, value});
      if (value != 0 && value != 0xFF00) {
        check_refused(memory, bytes, 3);
      } else if (address >= kBits) {
        check_refused(memory, bytes, 2);
      } else {
        Memory expected = memory;
        set_bit(expected.coils, address, value != 0);
        const Reply reply = ask(memory, bytes);
        CHECK(reply.bytes == bytes);
        CHECK(memory == expected);
        CHECK(reply.answer.written == link::Table::coil);
        CHECK(reply.answer.first == address);
        CHECK(reply.answer.count == 1);
      }
    }
  }
}

TEST_CASE("writing one register (06) takes any value") {
  Memory memory(kBits, kRegisters);
  for (const std::uint32_t address : addresses(kRegisters)) {
    for (const std::uint32_t value : {0x0000U, 0x0001U, 0x7FFFU, 0x8000U, 0xFFFFU}) {
      CAPTURE(address, value);
      const Bytes bytes = request(6, {address, value});
      if (address >= kRegisters) {
        check_refused(memory, bytes, 2);
        continue;
      }
      Memory expected = memory;
      set_register(expected.holding, address, static_cast<std::uint16_t>(value));
      const Reply reply = ask(memory, bytes);
      CHECK(reply.bytes == bytes);
      CHECK(memory == expected);
      CHECK(reply.answer.written == link::Table::holding_register);
    }
  }
}

TEST_CASE("writing coils (15) at every boundary, all or nothing") {
  for (const std::uint32_t address : addresses(kBits)) {
    for (const std::uint32_t quantity : quantities(1968)) {
      Memory memory(kBits, kRegisters);
      CAPTURE(address, quantity);
      const std::uint32_t count = (quantity + 7) / 8;
      Bytes bytes = request(15, {address, quantity});
      bytes.push_back(static_cast<std::uint8_t>(count));  // beyond a byte the request is wrong anyhow
      for (std::uint32_t i = 0; i < std::min(count, 247U); ++i) bytes.push_back(static_cast<std::uint8_t>(0xA7 + i));
      const int exception = expected_exception(address, quantity, 1968, kBits);
      if (exception != 0) {
        check_refused(memory, bytes, exception);
        continue;
      }
      Memory expected = memory;
      for (std::uint32_t i = 0; i < quantity; ++i) {
        set_bit(expected.coils, address + i, ((0xA7 + i / 8) >> (i % 8) & 1) != 0);
      }
      const Reply reply = ask(memory, bytes);
      CHECK(reply.bytes == request(15, {address, quantity}));
      CHECK(memory == expected);
      CHECK(reply.answer.first == address);
      CHECK(reply.answer.count == quantity);
    }
  }
}

TEST_CASE("writing registers (16) at every boundary, all or nothing") {
  for (const std::uint32_t address : addresses(kRegisters)) {
    for (const std::uint32_t quantity : quantities(123)) {
      Memory memory(kBits, kRegisters);
      CAPTURE(address, quantity);
      Bytes bytes = request(16, {address, quantity});
      bytes.push_back(static_cast<std::uint8_t>(2 * quantity));
      for (std::uint32_t i = 0; i < std::min(quantity, 124U); ++i) put(bytes, 0x8001 + 3 * i);
      const int exception = expected_exception(address, quantity, 123, kRegisters);
      if (exception != 0) {
        check_refused(memory, bytes, exception);
        continue;
      }
      Memory expected = memory;
      for (std::uint32_t i = 0; i < quantity; ++i) {
        set_register(expected.holding, address + i, static_cast<std::uint16_t>(0x8001 + 3 * i));
      }
      const Reply reply = ask(memory, bytes);
      CHECK(reply.bytes == request(16, {address, quantity}));
      CHECK(memory == expected);
      CHECK(reply.answer.count == quantity);
    }
  }
}

TEST_CASE("a byte count that does not fit the quantity is refused, both ways, also where the address is wrong") {
  Memory memory(kBits, kRegisters);
  for (const std::uint32_t address : {0U, kBits}) {
    check_refused(memory,
                  {15, static_cast<std::uint8_t>(address >> 8), static_cast<std::uint8_t>(address), 0, 8, 2, 1, 1}, 3);
    check_refused(memory, {15, static_cast<std::uint8_t>(address >> 8), static_cast<std::uint8_t>(address), 0, 9, 1, 1},
                  3);
    check_refused(
        memory, {16, static_cast<std::uint8_t>(address >> 8), static_cast<std::uint8_t>(address), 0, 1, 4, 1, 1, 1, 1},
        3);
    check_refused(memory,
                  {16, static_cast<std::uint8_t>(address >> 8), static_cast<std::uint8_t>(address), 0, 2, 2, 1, 1}, 3);
  }
}

TEST_CASE("a request shorter or longer than its function implies is refused") {
  Memory memory(kBits, kRegisters);
  const std::vector<Bytes> good = {{1, 0, 0, 0, 1},        {2, 0, 0, 0, 1},          {3, 0, 0, 0, 1},
                                   {4, 0, 0, 0, 1},        {5, 0, 0, 0xFF, 0},       {6, 0, 0, 0, 1},
                                   {15, 0, 0, 0, 1, 1, 1}, {16, 0, 0, 0, 1, 2, 0, 1}};
  for (const Bytes& bytes : good) {
    CAPTURE(bytes);
    for (std::size_t size = 1; size < bytes.size(); ++size) {
      check_refused(memory, Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)), 3);
    }
    Bytes longer = bytes;
    longer.push_back(0);
    check_refused(memory, longer, 3);
    CHECK(ask(memory, bytes).answer.exception == Exception::none);
  }
}

TEST_CASE("a function code that is not served gets exception 01, a reserved one no reply") {
  Memory memory(kBits, kRegisters);
  const std::vector<int> served = {1, 2, 3, 4, 5, 6, 15, 16};
  for (int code = 0; code < 256; ++code) {
    if (std::count(served.begin(), served.end(), code) != 0) continue;
    for (const std::size_t size : {std::size_t{1}, std::size_t{5}, kMaxPdu}) {
      CAPTURE(code, size);
      Bytes bytes(size, 0);
      bytes[0] = static_cast<std::uint8_t>(code);
      if (code < 128) {
        check_refused(memory, bytes, 1);
      } else {
        CHECK(ask(memory, bytes).bytes.empty());
      }
    }
  }
  CHECK(ask(memory, {}).bytes.empty());
}

TEST_CASE("a table without places answers every address with 02") {
  Memory memory(0, 0);
  for (const std::uint8_t code : {std::uint8_t{1}, std::uint8_t{2}, std::uint8_t{3}, std::uint8_t{4}}) {
    check_refused(memory, request(code, {0, 1}), 2);
  }
  check_refused(memory, request(5, {0, 0xFF00}), 2);
  check_refused(memory, request(6, {0, 1}), 2);
  check_refused(memory, {15, 0, 0, 0, 1, 1, 1}, 2);
  check_refused(memory, {16, 0, 0, 0, 1, 2, 0, 1}, 2);
}

TEST_CASE("the last place of a full table is served, and no address wraps round") {
  Memory memory(65'536, 65'536);
  CHECK(ask(memory, request(1, {0xFFFF, 1})).bytes == Bytes{1, 1, 1});  // 65535 is a multiple of 3
  check_refused(memory, request(1, {0xFFFF, 2}), 2);
  check_refused(memory, request(3, {0xFFFF, 2}), 2);
  CHECK(ask(memory, request(6, {0xFFFF, 0x1234})).bytes == request(6, {0xFFFF, 0x1234}));
  CHECK(get_register(memory.holding, 0xFFFF) == 0x1234);
}

TEST_CASE("a refusal as busy names the function, and none goes to a reserved code") {
  std::array<std::uint8_t, kMaxPdu> reply{};
  CHECK(refuse_request(Bytes{3, 0, 0, 0, 1}, Exception::server_device_busy, reply).size == 2);
  CHECK(reply[0] == 0x83);
  CHECK(reply[1] == 6);
  CHECK(refuse_request(Bytes{0x83}, Exception::server_device_busy, reply).size == 0);
}

TEST_CASE("requests of random bytes are answered within bounds, and an exception changes nothing") {
  std::mt19937 random(1);
  Memory memory(48, 16);
  for (int i = 0; i < 200'000; ++i) {
    Bytes bytes(random() % 16);
    for (auto& byte : bytes) byte = random() % 2 == 0 ? static_cast<std::uint8_t>(random() % 20) : std::uint8_t{0};
    const Memory before = memory;
    const Reply reply = ask(memory, bytes);
    REQUIRE(reply.bytes.size() <= kMaxPdu);
    if (reply.answer.count == 0) REQUIRE(memory == before);
  }
}
