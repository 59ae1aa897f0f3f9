// Every limit of section 1.8: the most that a request may hold is accepted, one more is refused with its end code.
#include "support/catch.hpp"
#include "unit/slmp_plc/requests.hpp"

using namespace symplant::test::slmp;

namespace {

struct Variant {
  Family family;
  Port port;
  Code code;
  bool is_iqr;  ///< iQ-R subcommands
};

std::vector<Variant> variants() {
  std::vector<Variant> all;
  for (const Code code : {Code::binary, Code::ascii}) {
    for (const Family family : kFamilies) all.push_back({family, Port::built_in, code, false});
    all.push_back({Family::q, Port::e71, code, false});
    all.push_back({Family::iqr, Port::built_in, code, true});
  }
  return all;
}

std::uint16_t end_code_of(const Variant& variant, const Request& request) {
  PlcMemory memory(variant.family);
  memory.configure("M", 20'000);
  memory.configure("B", 20'000);
  Cpu cpu;
  cpu.profile = profile_of(variant.family, variant.port);
  cpu.code = variant.code;
  return execute(request.frame(), cpu, memory).end_code;
}

Request request_of(const Variant& variant, std::uint16_t command, std::uint16_t subcommand) {
  return Request(command, static_cast<std::uint16_t>(subcommand + (variant.is_iqr ? 2 : 0)), variant.code);
}

std::uint16_t batch(const Variant& variant, std::uint16_t command, bool is_bit, std::string_view device,
                    std::uint32_t points) {
  Request request = request_of(variant, command, is_bit ? 1 : 0);
  request.device(device, 0).number(points, 2);
  const std::vector<std::uint32_t> values(command == kWrite ? points : 0, 1);
  return end_code_of(variant, is_bit ? request.bits(values) : request.words(values));
}

std::uint16_t random(const Variant& variant, std::uint16_t command, std::uint32_t words, std::uint32_t dwords) {
  Request request = request_of(variant, command, 0);
  request.number(words, 1).number(dwords, 1);
  for (std::uint32_t i = 0; i < words + dwords; ++i) {
    request.device("D", 2 * i);
    if (command == kWriteRandom) request.number(i, i < words ? 2 : 4);
  }
  return end_code_of(variant, request);
}

std::uint16_t random_bits(const Variant& variant, std::uint32_t points) {
  Request request = request_of(variant, kWriteRandom, 1);
  request.number(points, 1);
  for (std::uint32_t i = 0; i < points; ++i) request.device("M", i).number(1, variant.is_iqr ? 2 : 1);
  return end_code_of(variant, request);
}

/// Blocks of D with one point each, the last one with more, so that there are `points` together.
std::uint16_t blocks(const Variant& variant, std::uint16_t command, std::uint32_t count, std::uint32_t points) {
  Request request = request_of(variant, command, 0);
  request.number(count, 1).number(0, 1);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t size = i + 1 < count ? 1 : points - i;
    request.device("D", i).number(size, 2);
    if (command == kWriteBlocks) request.words(std::vector<std::uint32_t>(size, 1));
  }
  return end_code_of(variant, request);
}

std::string name_of(const Variant& variant) {
  static constexpr std::array kFamilyNames = {"Q", "L", "iQ-R", "FX5"};
  return std::string(kFamilyNames[static_cast<std::size_t>(variant.family)]) +
         (variant.port == Port::e71 ? " E71" : "") + (variant.code == Code::ascii ? " ASCII" : "") +
         (variant.is_iqr ? " 0002" : " 0000");
}

bool is_fx5(const Variant& variant) { return variant.family == Family::fx5; }

}  // namespace

TEST_CASE("Word requests hold 960 points, on FX5 in ASCII 480") {
  for (const Variant& variant : variants()) {
    INFO(name_of(variant));
    const std::uint32_t most = is_fx5(variant) && variant.code == Code::ascii ? 480 : 960;
    const std::uint16_t refusal = is_fx5(variant) ? 0xC052 : 0xC051;
    for (const std::uint16_t command : {kRead, kWrite}) {
      for (const std::string_view device : {"D", "M"}) {
        CHECK(batch(variant, command, false, device, most) == 0);
        CHECK(batch(variant, command, false, device, most + 1) == refusal);
        CHECK(batch(variant, command, false, device, 0) == refusal);
      }
    }
  }
}

TEST_CASE("Bit requests hold 7168 points, in ASCII and on FX5 half of them") {
  for (const Variant& variant : variants()) {
    INFO(name_of(variant));
    const std::uint32_t most = 7168U / (is_fx5(variant) ? 2 : 1) / (variant.code == Code::ascii ? 2 : 1);
    const std::uint16_t refusal = is_fx5(variant) ? 0xC051 : 0xC052;
    for (const std::uint16_t command : {kRead, kWrite}) {
      CHECK(batch(variant, command, true, "M", most) == 0);
      CHECK(batch(variant, command, true, "M", most + 1) == refusal);
      CHECK(batch(variant, command, true, "M", 0) == refusal);
    }
  }
}

TEST_CASE("Random reads hold 192 words and dwords, with iQ-R subcommands 96") {
  for (const Variant& variant : variants()) {
    INFO(name_of(variant));
    const std::uint32_t most = variant.is_iqr ? 96 : 192;
    const std::uint16_t refusal = variant.port == Port::e71 ? 0x4080 : 0xC054;
    for (const std::uint32_t dwords : {0U, 1U, 50U, most}) {
      CHECK(random(variant, kReadRandom, most - dwords, dwords) == 0);
      CHECK(random(variant, kReadRandom, most - dwords + 1, dwords) == refusal);
    }
    CHECK(random(variant, kReadRandom, 0, 0) == refusal);
  }
}

TEST_CASE("Random writes weigh words with 12 and dwords with 14") {
  for (const Variant& variant : variants()) {
    INFO(name_of(variant));
    const std::uint32_t most = variant.is_iqr ? 960 : 1920;
    const std::uint16_t refusal = variant.port == Port::e71 ? 0x4080 : 0xC054;
    for (const std::uint32_t dwords : {0U, 1U, 30U, variant.is_iqr ? 68U : 137U}) {
      const std::uint32_t words = (most - 14 * dwords) / 12;
      CHECK(random(variant, kWriteRandom, words, dwords) == 0);
      CHECK(random(variant, kWriteRandom, words + 1, dwords) == refusal);
    }
    CHECK(random(variant, kWriteRandom, 0, variant.is_iqr ? 69 : 138) == refusal);
    CHECK(random(variant, kWriteRandom, variant.is_iqr ? 80 : 160, 0) == 0);
  }
}

TEST_CASE("Random writes of bits hold 188 points, with iQ-R subcommands 94") {
  for (const Variant& variant : variants()) {
    INFO(name_of(variant));
    const std::uint32_t most = variant.is_iqr ? 94 : 188;
    CHECK(random_bits(variant, most) == 0);
    CHECK(random_bits(variant, most + 1) == 0xC053);
    CHECK(random_bits(variant, 0) == 0xC053);
  }
}

TEST_CASE("Block requests hold 120 blocks, with iQ-R subcommands 60") {
  for (const Variant& variant : variants()) {
    INFO(name_of(variant));
    const std::uint16_t refusal = is_fx5(variant) ? 0xC052 : 0xC051;
    const bool has_blocks = profile_of(variant.family, variant.port).has_blocks;
    const std::uint32_t most = variant.is_iqr ? 60 : 120;
    for (const std::uint16_t command : {kReadBlocks, kWriteBlocks}) {
      CHECK(blocks(variant, command, most, most) == (has_blocks ? 0 : 0xC059));
      CHECK(blocks(variant, command, most + 1, most + 1) == (has_blocks ? refusal : 0xC059));
    }
  }
}

TEST_CASE("Block requests hold 960 points, a write less 4 or 9 for each block") {
  for (const Variant& variant : variants()) {
    if (!profile_of(variant.family, variant.port).has_blocks) continue;
    INFO(name_of(variant));
    const std::uint16_t refusal = is_fx5(variant) ? 0xC052 : 0xC051;
    for (const std::uint32_t count : {1U, 2U, 60U}) {
      CHECK(blocks(variant, kReadBlocks, count, 960) == 0);
      CHECK(blocks(variant, kReadBlocks, count, 961) == refusal);
      const std::uint32_t most = 960 - count * (variant.is_iqr ? 9 : 4);
      CHECK(blocks(variant, kWriteBlocks, count, most) == 0);
      CHECK(blocks(variant, kWriteBlocks, count, most + 1) == refusal);
    }
  }
}

TEST_CASE("A loopback holds 1 to 960 characters") {
  const Variant iqr = {Family::iqr, Port::built_in, Code::binary, false};
  const auto loopback = [&](std::uint32_t size) {
    return end_code_of(iqr, Request(kLoopback, 0).number(size, 2).text(std::string(size, 'A')));
  };
  CHECK(loopback(1) == 0);
  CHECK(loopback(960) == 0);
  CHECK(loopback(961) == kContent);
  CHECK(loopback(0) == kContent);
}
