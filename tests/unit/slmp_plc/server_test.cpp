// The PLC as a server: scan program, I/O refresh, states, log.
#include "support/catch.hpp"
#include "support/slmp/slmp_plc.hpp"
#include "unit/slmp_plc/requests.hpp"

using namespace symplant::test::slmp;

namespace {

Request write_bit(std::string_view device, std::uint32_t number, bool on) {
  return Request(kWrite, 1).device(device, number).number(1, 2).bits({on ? 1U : 0U});
}

Request read_words(std::string_view device, std::uint32_t number, std::uint32_t count) {
  return Request(kRead, 0).device(device, number).number(count, 2);
}

/// The end code of a 3E reply.
std::uint16_t asked(const WireClient& client, const Request& request) {
  client.send(request.bytes());
  const Bytes header = client.receive(11);
  if (header.size() != 11) return 0xFFFF;
  client.receive(header[7] + std::size_t{256} * header[8] - 2);
  return static_cast<std::uint16_t>(header[9] + 256 * header[10]);
}

}  // namespace

TEST_CASE("A scan program sees what a client writes and replies with outputs") {
  SlmpPlc plc({.program = [](PlcMemory& memory) { memory.set_bit("Y", 0x20, memory.bit("X", 0x10)); }});
  const WireClient client(plc.port());
  CHECK(asked(client, write_bit("X", 0x10, true)) == 0);
  CHECK(plc.wait_until([&] { return plc.memory().bit("Y", 0x20); }));
  client.send(read_words("Y", 0x20, 1).bytes());
  CHECK(client.receive(13).at(11) == 1);
}

TEST_CASE("Without a scan interval only the test scans") {
  SlmpPlc plc({.program = [](PlcMemory& memory) { memory.set_word("D", 0, 7); },
               .scan_interval = std::chrono::milliseconds(0)});
  const WireClient client(plc.port());
  CHECK(asked(client, read_words("D", 0, 1)) == 0);
  CHECK(plc.memory().word("D", 0) == 0);
  plc.scan_once();
  CHECK(plc.memory().word("D", 0) == 7);
  CHECK(plc.scans() == 1);
}

TEST_CASE("The I/O refresh overwrites X of input modules before each scan") {
  SlmpPlc plc({.refreshed = {{"X", 0, 16}}, .scan_interval = std::chrono::milliseconds(0)});
  const WireClient client(plc.port());
  asked(client, write_bit("X", 3, true));
  asked(client, write_bit("X", 16, true));
  plc.set_terminal(5, true);
  plc.scan_once();
  CHECK_FALSE(plc.memory().bit("X", 3));
  CHECK(plc.memory().bit("X", 5));
  CHECK(plc.memory().bit("X", 16));
}

TEST_CASE("A stopped PLC does not scan, says so in SD203, and accepts writes") {
  SlmpPlc plc({.writes_in_run = false,
               .program = [](PlcMemory&) {},
               .scan_interval = std::chrono::milliseconds(0),
               .clears_x_at_run_change = true});
  const WireClient client(plc.port());
  CHECK(asked(client, write_bit("M", 0, true)) == kNotInRun);
  plc.memory().set_bit("X", 1, true);
  plc.set_running(false);
  CHECK(plc.memory().word("SD", 203) == 2);
  CHECK_FALSE(plc.memory().bit("X", 1));
  plc.scan_once();
  CHECK(plc.scans() == 0);
  CHECK(asked(client, write_bit("M", 0, true)) == 0);
  plc.set_running(true);
  CHECK(asked(client, write_bit("M", 0, true)) == kNotInRun);
  plc.set_writes_in_run(true);
  CHECK(asked(client, write_bit("M", 0, true)) == 0);
  CHECK(plc.log().violations().empty());
}

TEST_CASE("The log has every request and every address written") {
  SlmpPlc plc;
  const WireClient client(plc.port());
  asked(client, Request(kWrite, 0).device("M", 16).number(1, 2).words({1}));
  asked(client, Request(kWriteRandom, 0).number(0, 1).number(1, 1).device("D", 9).number(5, 4));
  asked(client, read_words("W", 0, 3));
  CHECK(plc.log().count() == 3);
  CHECK(plc.log().count(kWrite) == 1);
  const std::vector<LoggedRequest> requests = plc.log().requests();
  CHECK(requests[0].ranges == std::vector<DeviceRange>{{"M", 16, 16}});
  CHECK(requests[2].ranges == std::vector<DeviceRange>{{"W", 0, 3}});
  CHECK(requests[2].points == 3);
  CHECK_FALSE(requests[2].is_write);
  CHECK(plc.log().writes().size() == 18);
  CHECK(plc.log().writes_outside({{"M", 16, 16}, {"D", 9, 2}}).empty());
  CHECK(plc.log().writes_outside({{"M", 16, 15}, {"D", 9, 2}}) == std::vector<Address>{{"M", 31}});
  CHECK(plc.log().most_outstanding() == 1);
  plc.log().clear();
  CHECK(plc.log().writes().empty());
}

TEST_CASE("Broken limits and duplicate destinations are violations, questions for abilities are not") {
  SlmpPlc plc({.profile = profile_of(Family::q)});
  const WireClient client(plc.port());
  CHECK(asked(client, Request(kReadModel, 0)) == kCommand);
  CHECK(plc.log().violations().empty());
  CHECK(asked(client, read_words("D", 0, 961)) == 0xC051);
  CHECK(plc.log().violations() == std::vector<std::string>{"0401/0000 of 961 points: C051"});
  Request twice(kWriteRandom, 1);
  twice.number(2, 1).device("M", 4).number(1, 1).device("M", 4).number(0, 1);
  CHECK(asked(client, twice) == 0);
  CHECK(plc.log().violations().size() == 2);
  CHECK(asked(client, Request(kWrite, 0).number(0xFFFFFF, 3).number(0x90, 1).number(1, 2).words({1})) == 0x4031);
  CHECK(plc.log().violations().size() == 3);
}
