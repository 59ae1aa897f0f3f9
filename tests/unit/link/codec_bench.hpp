// A Modbus server's memory and requests to it, for the tests of the codec.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <numeric>
#include <vector>

#include "support/catch.hpp"
#include "symplant/link/modbus/codec.hpp"

namespace symplant::test {

using namespace symplant::link::image;
using namespace symplant::link::modbus;
using Bytes = std::vector<std::uint8_t>;

/// A server's memory, filled with a different value at each address.
struct Memory {
  std::vector<std::uint64_t> coils, discrete, holding, input;
  std::vector<std::uint32_t> input_lanes;  ///< the registers in their order
  std::uint32_t bits;
  std::uint32_t registers;

  explicit Memory(std::uint32_t bit_count, std::uint32_t register_count)
      : coils(bit_words(bit_count)),
        discrete(bit_words(bit_count)),
        holding(lane_words(register_count)),
        input(lane_words(register_count)),
        input_lanes(register_count),
        bits(bit_count),
        registers(register_count) {
    std::iota(input_lanes.begin(), input_lanes.end(), 0U);
    for (std::uint32_t i = 0; i < bits; ++i) {
      set_bit(coils, i, i % 3 == 0);
      set_bit(discrete, i, i % 5 < 2);
    }
    for (std::uint32_t i = 0; i < registers; ++i) {
      set_lane(holding, i, static_cast<std::uint16_t>(i * 7 + 1));
      set_lane(input, i, static_cast<std::uint16_t>(0xF000 + i));
    }
  }

  Tables tables() { return {{coils, bits}, {discrete, bits}, {holding, registers}, {input, input_lanes}}; }
  bool operator==(const Memory&) const = default;
};

inline void put(Bytes& bytes, std::uint32_t value) {
  bytes.push_back(static_cast<std::uint8_t>(value >> 8));
  bytes.push_back(static_cast<std::uint8_t>(value & 0xFF));
}

inline Bytes request(std::uint8_t code, std::initializer_list<std::uint32_t> fields) {
  Bytes bytes = {code};
  for (const std::uint32_t field : fields) put(bytes, field);
  return bytes;
}

struct Reply {
  Bytes bytes;
  Answer answer;
};

inline constexpr Identity kIdentity = {"maker", "plant", "1.2"};

inline Reply ask(Memory& memory, const Bytes& bytes) {
  std::array<std::uint8_t, kMaxPdu> reply{};
  const Answer answer = answer_request(bytes, memory.tables(), kIdentity, reply);
  return {Bytes(reply.begin(), reply.begin() + static_cast<std::ptrdiff_t>(answer.size)), answer};
}

/// Requires an exception, and that no memory has changed.
inline void check_refused(Memory& memory, const Bytes& bytes, int exception) {
  const Memory before = memory;
  const Reply reply = ask(memory, bytes);
  CHECK(reply.bytes == Bytes{static_cast<std::uint8_t>(bytes[0] | 0x80), static_cast<std::uint8_t>(exception)});
  CHECK(static_cast<int>(reply.answer.exception) == exception);
  CHECK(reply.answer.count == 0);
  CHECK(memory == before);
}

inline constexpr std::uint32_t kBits = 2016;
inline constexpr std::uint32_t kRegisters = 160;

}  // namespace symplant::test
