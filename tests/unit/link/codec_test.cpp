// Malformed requests, unsupported functions, empty and full tables, random bytes.
#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "unit/link/codec_bench.hpp"

using namespace symplant;
using namespace symplant::test;

TEST_CASE("A byte count that does not match the quantity is rejected, also with an invalid address") {
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

TEST_CASE("A request shorter or longer than its function implies is rejected") {
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

TEST_CASE("An unsupported function code gets exception 01, a reserved one gets no reply") {
  Memory memory(kBits, kRegisters);
  const std::vector<int> served = {1, 2, 3, 4, 5, 6, 15, 16, 22, 23, 43};
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

TEST_CASE("An answer contains what was read and what was written") {
  Memory memory(kBits, kRegisters);
  const Answer both = ask(memory, {23, 0, 4, 0, 3, 0, 5, 0, 1, 2, 0xBE, 0xEF}).answer;
  CHECK(both.read == link::modbus::Table::holding_register);
  CHECK(both.read_first == 4);
  CHECK(both.read_count == 3);
  CHECK(both.written == link::modbus::Table::holding_register);
  CHECK(both.first == 5);
  CHECK(both.count == 1);
  const Answer inputs = ask(memory, request(2, {7, 2})).answer;
  CHECK(inputs.read == link::modbus::Table::discrete_input);
  CHECK(inputs.read_first == 7);
  CHECK(inputs.read_count == 2);
  CHECK(inputs.count == 0);
  CHECK(ask(memory, request(2, {kBits, 1})).answer.read_count == 0);
  CHECK(ask(memory, request(22, {9, 0xFF00, 1})).answer.first == 9);
}

TEST_CASE("The server identifies itself, in printable ASCII of at most 64 bytes per text") {
  std::array<std::uint8_t, kMaxPdu> reply{};
  Memory memory(16, 16);
  const std::string name = "caf\xC3\xA9 \n" + std::string(300, 'x');
  const Identity identity = {"maker", name, "1"};
  const Answer answer = answer_request(Bytes{43, 14, 4, 1}, memory.tables(), identity, reply);
  REQUIRE(answer.size == 7 + 2 + Identity::kMaxObject);
  CHECK(std::string(reply.begin() + 9, reply.begin() + 18) == "caf?? ?xx");
  CHECK(answer_request(Bytes{43, 14, 1, 0}, memory.tables(), identity, reply).size == 7 + 7 + 66 + 3);
}

TEST_CASE("An empty table answers every address with 02") {
  Memory memory(0, 0);
  for (const std::uint8_t code : {std::uint8_t{1}, std::uint8_t{2}, std::uint8_t{3}, std::uint8_t{4}}) {
    check_refused(memory, request(code, {0, 1}), 2);
  }
  check_refused(memory, request(5, {0, 0xFF00}), 2);
  check_refused(memory, request(6, {0, 1}), 2);
  check_refused(memory, {15, 0, 0, 0, 1, 1, 1}, 2);
  check_refused(memory, {16, 0, 0, 0, 1, 2, 0, 1}, 2);
}

TEST_CASE("The last address of a full table is served, and no address wraps") {
  Memory memory(65'536, 65'536);
  CHECK(ask(memory, request(1, {0xFFFF, 1})).bytes == Bytes{1, 1, 1});  // 65535 is a multiple of 3
  check_refused(memory, request(1, {0xFFFF, 2}), 2);
  check_refused(memory, request(3, {0xFFFF, 2}), 2);
  CHECK(ask(memory, request(6, {0xFFFF, 0x1234})).bytes == request(6, {0xFFFF, 0x1234}));
  CHECK(get_lane(memory.holding, 0xFFFF) == 0x1234);
}

TEST_CASE("A busy answer names the function, and a reserved code gets none") {
  std::array<std::uint8_t, kMaxPdu> reply{};
  CHECK(refuse_request(Bytes{3, 0, 0, 0, 1}, Exception::server_device_busy, reply).size == 2);
  CHECK(reply[0] == 0x83);
  CHECK(reply[1] == 6);
  CHECK(refuse_request(Bytes{0x83}, Exception::server_device_busy, reply).size == 0);
}

TEST_CASE("Requests of random bytes are answered within bounds, and an exception changes nothing") {
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
