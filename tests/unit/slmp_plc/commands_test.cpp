// What the PLC makes of requests: packing of data, order of values, end codes.
#include "support/catch.hpp"
#include "unit/slmp_plc/requests.hpp"

using namespace symplant::test::slmp;

namespace {

struct Plc {
  explicit Plc(Family family = Family::iqr, Port port = Port::built_in, Code code = Code::binary) : memory(family) {
    cpu.profile = profile_of(family, port);
    cpu.code = code;
    cpu.model = "R08CPU";
    cpu.model_code = 0x4801;
  }
  Outcome run(const Request& request) { return execute(request.frame(), cpu, memory); }
  std::uint16_t end_code(const Request& request) { return run(request).end_code; }
  Bytes data(const Request& request) {
    const Outcome outcome = run(request);
    CHECK(outcome.end_code == 0);
    return outcome.data;
  }
  std::string text(const Request& request) {
    const Bytes bytes = data(request);
    return {bytes.begin(), bytes.end()};
  }

  PlcMemory memory;
  Cpu cpu;
};

}  // namespace

TEST_CASE("Bits are packed two in a byte, the first in the high half") {
  Plc plc;
  CHECK(plc.data(Request(kWrite, 1).device("M", 100).number(5, 2).number(0x0011, 2).number(0x10, 1)).empty());
  CHECK(plc.memory.word("M", 100) == 0b10011);
  CHECK(plc.data(Request(kRead, 1).device("M", 100).number(5, 2)) == Bytes{0x11, 0x00, 0x10});
  CHECK(plc.data(Request(kRead, 1).device("M", 104).number(1, 2)) == Bytes{0x10});
  CHECK(plc.data(Request(kRead, 1).device("M", 101).number(2, 2)) == Bytes{0x10});
}

TEST_CASE("The half byte after an odd number of bits is ignored") {
  Plc plc;
  CHECK(plc.end_code(Request(kWrite, 1).device("M", 0).number(1, 2).number(0x1F, 1)) == 0);
  CHECK(plc.memory.word("M", 0) == 1);
}

TEST_CASE("Words of a bit device hold 16 points, the head in bit 0") {
  Plc plc;
  plc.memory.set_word("M", 100, 0x1234);
  plc.memory.set_word("M", 116, 0x0002);
  CHECK(plc.data(Request(kRead, 0).device("M", 100).number(2, 2)) == Bytes{0x34, 0x12, 0x02, 0x00});
  CHECK(plc.end_code(Request(kWrite, 0).device("X", 0x25).number(1, 2).words({0x8001})) == 0);
  CHECK(plc.memory.bit("X", 0x25));
  CHECK(plc.memory.bit("X", 0x34));
  CHECK_FALSE(plc.memory.bit("X", 0x26));
}

TEST_CASE("Random reads give words and then dwords, low words first") {
  Plc plc;
  plc.memory.set_word("D", 0, 0x1995);
  plc.memory.set_word("X", 0x20, 0xBEEF);
  plc.memory.set_dword("D", 1500, 0x4C544F4E);
  plc.memory.set_dword("M", 160, 0x80000001);
  Request request(kReadRandom, 0);
  request.number(2, 1).number(2, 1).device("D", 0).device("X", 0x20).device("D", 1500).device("M", 160);
  CHECK(plc.data(request) == Bytes{0x95, 0x19, 0xEF, 0xBE, 0x4E, 0x4F, 0x54, 0x4C, 0x01, 0x00, 0x00, 0x80});
}

TEST_CASE("Random writes set words, dwords and bits") {
  Plc plc;
  Request words(kWriteRandom, 2);
  words.number(1, 1).number(1, 1).device("D", 1).number(0x0575, 2).device("D", 1500).number(0x04391202, 4);
  CHECK(plc.end_code(words) == 0);
  CHECK(plc.memory.word("D", 1) == 0x0575);
  CHECK(plc.memory.dword("D", 1500) == 0x04391202);
  Request bits(kWriteRandom, 3);
  plc.memory.set_bit("M", 50, true);
  bits.number(2, 1).device("M", 50).number(0, 2).device("Y", 0x2F).number(1, 2);
  CHECK(plc.end_code(bits) == 0);
  CHECK_FALSE(plc.memory.bit("M", 50));
  CHECK(plc.memory.bit("Y", 0x2F));
}

TEST_CASE("Block writes have points and data in each block") {
  Plc plc;
  Request request(kWriteBlocks, 0);
  request.number(2, 1).number(1, 1).device("D", 0).number(2, 2).words({8, 0x20}).device("W", 0x100).number(1, 2);
  request.words({7}).device("M", 0).number(1, 2).words({0x000C});
  CHECK(plc.end_code(request) == 0);
  CHECK(plc.memory.word("D", 1) == 0x20);
  CHECK(plc.memory.word("W", 0x100) == 7);
  CHECK(plc.memory.word("M", 0) == 0x000C);
  Request read(kReadBlocks, 0);
  read.number(1, 1).number(1, 1).device("D", 0).number(2, 2).device("M", 0).number(1, 2);
  CHECK(plc.data(read) == Bytes{8, 0, 0x20, 0, 0x0C, 0});
}

TEST_CASE("A layout with all blocks first and all data last is refused") {
  Plc plc;
  Request request(kWriteBlocks, 0);
  request.number(1, 1).number(1, 1).device("D", 0).number(2, 2).device("M", 0).number(1, 2).words({8, 0x20, 0x0C});
  CHECK(plc.end_code(request) != 0);
}

TEST_CASE("ASCII data is upper-case hex, a character for each bit") {
  Plc plc(Family::iqr, Port::built_in, Code::ascii);
  plc.memory.set_word("D", 100, 0x1995);
  plc.memory.set_word("X", 0x10, 0b10011);
  plc.memory.set_dword("D", 1500, 0x4C544F4E);
  CHECK(plc.text(Request(kRead, 0, Code::ascii).device("D", 100).number(2, 2)) == "19950000");
  CHECK(plc.text(Request(kRead, 1, Code::ascii).device("X", 0x10).number(5, 2)) == "11001");
  CHECK(plc.text(Request(kReadRandom, 2, Code::ascii).number(0, 1).number(1, 1).device("D", 1500)) == "4C544F4E");
  CHECK(plc.text(Request(kReadModel, 0, Code::ascii)) == "R08CPU          4801");
  CHECK(plc.end_code(Request(kRead, 0, Code::ascii).text("D*00010").number(1, 2)) == kLength);
  CHECK(plc.end_code(Request(kRead, 0, Code::ascii).text("D*00010a").number(1, 2)) == kNotHex);
  CHECK(plc.end_code(Request(kRead, 0, Code::ascii).text("D*0010FF").number(1, 2)) == kNotHex);
  CHECK(plc.end_code(Request(kRead, 0, Code::ascii).text("Q*000100").number(1, 2)) == kDevice);
  CHECK(plc.text(Request(kRead, 0, Code::ascii).text("D*   100").number(1, 2)) == "1995");
  CHECK(plc.text(Request(kRead, 0, Code::ascii).text("SN000000").number(1, 2)) == "0000");
  CHECK(plc.text(Request(kRead, 2, Code::ascii).text("STN*00000000").number(1, 2)) == "0000");
}

TEST_CASE("Numbers of X and Y are hex in ASCII, on FX5 octal") {
  Plc plc(Family::fx5, Port::built_in, Code::ascii);
  plc.memory.set_bit("X", 8, true);
  CHECK(plc.text(Request(kRead, 1, Code::ascii).text("X*000008").number(1, 2)) == "1");
  plc.cpu.has_octal_input_output = true;
  CHECK(plc.text(Request(kRead, 1, Code::ascii).text("X*000010").number(1, 2)) == "1");
  CHECK(plc.end_code(Request(kRead, 1, Code::ascii).text("X*000008").number(1, 2)) == kNotHex);
}

TEST_CASE("The model is 16 characters and a code, a loopback returns its text") {
  Plc plc;
  const Bytes model = plc.data(Request(kReadModel, 0));
  REQUIRE(model.size() == 18);
  CHECK(std::string(model.begin(), model.begin() + 16) == "R08CPU          ");
  CHECK(Bytes(model.begin() + 16, model.end()) == Bytes{0x01, 0x48});
  CHECK(plc.data(Request(kLoopback, 0).number(5, 2).text("ABCDE")) == Bytes{5, 0, 'A', 'B', 'C', 'D', 'E'});
  CHECK(plc.end_code(Request(kLoopback, 0).number(1, 2).text("G")) == kContent);
}

TEST_CASE("Q and L without a network module have neither model nor blocks nor loopback") {
  for (const Family family : {Family::q, Family::l}) {
    Plc plain(family);
    Plc e71(family, Port::e71);
    const Request model(kReadModel, 0);
    const Request loopback = Request(kLoopback, 0).number(1, 2).text("A");
    const Request blocks = Request(kReadBlocks, 0).number(1, 1).number(0, 1).device("D", 0).number(1, 2);
    for (const Request& request : {model, loopback, blocks}) {
      CHECK(plain.end_code(request) == kCommand);
      CHECK(e71.end_code(request) == 0);
    }
  }
}

TEST_CASE("Unknown commands and subcommands get C059, iQ-R subcommands what the family has for them") {
  Plc plc;
  CHECK(plc.end_code(Request(0x0801, 0).number(0, 2)) == kCommand);
  CHECK(plc.end_code(Request(kRead, 4)) == kCommand);
  CHECK(plc.end_code(Request(kReadRandom, 1)) == kCommand);
  CHECK(plc.end_code(Request(kReadModel, 1)) == kCommand);
  const Request read = Request(kRead, 2).device("D", 0).number(1, 2);
  CHECK(plc.end_code(read) == 0);
  CHECK(Plc(Family::q).end_code(read) == kCommand);
  CHECK(Plc(Family::fx5).end_code(read) == kCommand);
  CHECK(Plc(Family::q, Port::e71).end_code(read) == kLength);
}

TEST_CASE("A request that is too short or too long gets C061") {
  Plc plc;
  CHECK(plc.end_code(Request(kRead, 0).device("D", 0)) == kLength);
  CHECK(plc.end_code(Request(kRead, 0).device("D", 0).number(1, 2).number(0, 1)) == kLength);
  CHECK(plc.end_code(Request(kWrite, 0).device("D", 0).number(2, 2).words({1})) == kLength);
  CHECK(plc.end_code(Request(kWrite, 0).device("D", 0).number(2, 2).words({1, 2, 3})) == kLength);
  CHECK(plc.end_code(Request(kWrite, 1).device("M", 0).number(3, 2).number(0x11, 1)) == kLength);
  CHECK(plc.end_code(Request(kReadRandom, 0).number(2, 1).number(0, 1).device("D", 0)) == kLength);
  CHECK(plc.end_code(Request(kWriteRandom, 1).number(1, 1).device("M", 0)) == kLength);
  CHECK(plc.end_code(Request(kReadModel, 0).number(0, 1)) == kLength);
  CHECK(plc.end_code(Request(kLoopback, 0).number(2, 2).text("ABC")) == kLength);
  CHECK(plc.memory.word("D", 0) == 0);
}

TEST_CASE("Devices that do not fit the command are refused") {
  Plc plc;
  CHECK(plc.end_code(Request(kRead, 1).device("D", 0).number(1, 2)) == kContent);
  CHECK(plc.end_code(Request(kRead, 0).number(0, 3).number(0x77, 1).number(1, 2)) == kDevice);
  CHECK(Plc(Family::q).end_code(Request(kRead, 0).device("RD", 0).number(1, 2)) == kDevice);
  CHECK(plc.end_code(Request(kWrite, 1).device("M", 0).number(1, 2).number(0x20, 1)) == kBitValue);
  CHECK(plc.end_code(Request(kWriteRandom, 1).number(1, 1).device("M", 0).number(2, 1)) == kBitValue);
  CHECK(plc.end_code(Request(kReadBlocks, 0).number(1, 1).number(0, 1).device("M", 0).number(1, 2)) == kDevice);
  for (const std::string_view device : {"TS", "TC", "CS", "CC", "STS", "STC"}) {
    CHECK(plc.end_code(Request(kReadRandom, 0).number(1, 1).number(0, 1).device(device, 0)) == kDeviceNotInThisCommand);
    CHECK(plc.end_code(Request(kRead, 1).device(device, 0).number(1, 2)) == 0);
  }
}

TEST_CASE("Steps are read-only except on FX5 and through an E71") {
  const Request write = Request(kWrite, 1).device("S", 0).number(1, 2).bits({1});
  for (const Family family : {Family::q, Family::l, Family::iqr}) CHECK(Plc(family).end_code(write) == kReadOnly);
  CHECK(Plc(Family::fx5).end_code(write) == 0);
  CHECK(Plc(Family::q, Port::e71).end_code(write) == 0);
}

TEST_CASE("Points beyond the configured ones get 4031, on FX5 C056") {
  for (const Family family : kFamilies) {
    Plc plc(family);
    const std::uint32_t points = plc.memory.points("X");
    const std::uint16_t refusal = family == Family::fx5 ? 0xC056 : 0x4031;
    CHECK(plc.end_code(Request(kRead, 1).device("X", points - 1).number(1, 2)) == 0);
    CHECK(plc.end_code(Request(kRead, 1).device("X", points - 1).number(2, 2)) == refusal);
    CHECK(plc.end_code(Request(kRead, 0).device("X", points - 16).number(1, 2)) == 0);
    CHECK(plc.end_code(Request(kRead, 0).device("X", points - 15).number(1, 2)) == refusal);
    CHECK(plc.end_code(Request(kWrite, 1).device("X", 0xFFFFFF).number(1, 2).bits({1})) == refusal);
  }
}

TEST_CASE("A random write that fails has applied the points before the failure") {
  Plc plc;
  Request request(kWriteRandom, 0);
  request.number(3, 1).number(0, 1).device("D", 1).number(5, 2).device("D", 60'000).number(6, 2);
  request.device("D", 2).number(7, 2);
  CHECK(plc.end_code(request) == kNumberOutOfRange);
  CHECK(plc.memory.word("D", 1) == 5);
  CHECK(plc.memory.word("D", 2) == 0);
}

TEST_CASE("Writes that are disabled get 0055, reads are served") {
  Plc plc;
  plc.cpu.accepts_writes = false;
  CHECK(plc.end_code(Request(kWrite, 1).device("M", 0).number(1, 2).bits({1})) == kNotInRun);
  CHECK(plc.end_code(Request(kWriteRandom, 1).number(1, 1).device("M", 0).number(1, 1)) == kNotInRun);
  CHECK(plc.end_code(Request(kRead, 1).device("M", 0).number(1, 2)) == 0);
  CHECK_FALSE(plc.memory.bit("M", 0));
}

TEST_CASE("A request for another station gets C05F") {
  Plc plc;
  plc.cpu.route.network = 1;
  CHECK(plc.end_code(Request(kRead, 0).device("D", 0).number(1, 2)) == kOtherTarget);
}
