// The table of function codes: each limit at its boundaries, with every kind of address.
//
// The expected answer is computed here from the rows of the specification, on tables with one entry per address.
#include <algorithm>
#include <vector>

#include "unit/link/codec_bench.hpp"

using namespace symplant;
using namespace symplant::test;

namespace {

std::vector<std::uint32_t> quantities(std::uint32_t max) { return {0, 1, max - 1, max, max + 1, 0xFFFF}; }
std::vector<std::uint32_t> addresses(std::uint32_t size) { return {0, size - 1, size, 0xFFFF}; }

/// The expected answer to a request for `quantity` addresses from `address`: 0 if it is valid.
int expected_exception(std::uint32_t address, std::uint32_t quantity, std::uint32_t max, std::uint32_t size) {
  if (quantity == 0 || quantity > max) return 3;
  return address + quantity > size ? 2 : 0;
}

}  // namespace

TEST_CASE("Reading bits (01, 02) is limited at every boundary") {
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
        Bytes expected(2 + (quantity + 7) / 8, 0);
        expected[0] = code;
        expected[1] = static_cast<std::uint8_t>((quantity + 7) / 8);
        for (std::uint32_t i = 0; i < quantity; ++i) {
          const std::uint32_t number = address + i;
          const bool on = code == 1 ? number % 3 == 0 : number % 5 < 2;
          if (on) expected[2 + i / 8] = static_cast<std::uint8_t>(expected[2 + i / 8] | 1U << (i % 8));
        }
        CHECK(ask(memory, bytes).bytes == expected);
      }
    }
  }
}

TEST_CASE("Reading registers (03, 04) is limited at every boundary") {
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

TEST_CASE("Writing one coil (05) checks the value before the address") {
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
        CHECK(reply.answer.written == link::modbus::Table::coil);
        CHECK(reply.answer.first == address);
        CHECK(reply.answer.count == 1);
      }
    }
  }
}

TEST_CASE("Writing one register (06) takes any value") {
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
      set_lane(expected.holding, address, static_cast<std::uint16_t>(value));
      const Reply reply = ask(memory, bytes);
      CHECK(reply.bytes == bytes);
      CHECK(memory == expected);
      CHECK(reply.answer.written == link::modbus::Table::holding_register);
    }
  }
}

TEST_CASE("Writing coils (15) at every boundary writes all or none") {
  for (const std::uint32_t address : addresses(kBits)) {
    for (const std::uint32_t quantity : quantities(1968)) {
      Memory memory(kBits, kRegisters);
      CAPTURE(address, quantity);
      const std::uint32_t count = (quantity + 7) / 8;
      Bytes bytes = request(15, {address, quantity});
      bytes.push_back(static_cast<std::uint8_t>(count));  // above 255 the request is invalid in any case
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

TEST_CASE("Writing registers (16) at every boundary writes all or none") {
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
        set_lane(expected.holding, address + i, static_cast<std::uint16_t>(0x8001 + 3 * i));
      }
      const Reply reply = ask(memory, bytes);
      CHECK(reply.bytes == request(16, {address, quantity}));
      CHECK(memory == expected);
      CHECK(reply.answer.count == quantity);
    }
  }
}
