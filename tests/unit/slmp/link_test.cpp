// The SLMP link in closed loop with a PLC.
#include "support/catch.hpp"
#include "unit/slmp/cell_bench.hpp"

using namespace symplant;
using Catch::Matchers::ContainsSubstring;
using exec::LinkState;
using test::CellClient;
using PlcCode = test::slmp::Code;
using test::slmp::DeviceRange;
using PlcFamily = test::slmp::Family;
using test::slmp::PlcMemory;
using test::slmp::PlcOptions;
using test::slmp::profile_of;
using test::slmp::SlmpPlc;

namespace {

PlcOptions cell_plc(PlcFamily family = PlcFamily::iqr, PlcCode code = PlcCode::binary) {
  PlcOptions options;
  options.profile = profile_of(family);
  options.code = code;
  options.program = [](PlcMemory& memory) { test::scan_cell(memory); };
  return options;
}

bool finishes(SlmpPlc& plc, std::uint16_t rounds) {
  return plc.wait_until([&plc, rounds] { return plc.memory().word("D", 0) >= rounds; });
}

/// Waits in the time of the PLC's scans, so that a slow machine waits longer.
template <class Holds>
bool soon(SlmpPlc& plc, Holds holds) {
  return plc.wait_until(holds);
}

const std::vector<DeviceRange> kCellInputs = {{"X", 1, 4}};

}  // namespace

TEST_CASE("The paper's cell closes the loop with every frame, code and transport") {
  for (const std::string frame : {"3e", "4e"}) {
    for (const PlcCode code : {PlcCode::binary, PlcCode::ascii}) {
      for (const std::string transport : {"tcp", "udp"}) {
        CAPTURE(frame, code == PlcCode::ascii, transport);
        SlmpPlc plc(cell_plc(PlcFamily::iqr, code));
        const CellClient client(plc.port(), "family=iqr&events=direct&poll=1ms&frame=" + frame + "&transport=" +
                                                transport + (code == PlcCode::ascii ? "&code=ascii" : ""));
        CHECK(finishes(plc, 2));
        CHECK(plc.log().violations().empty());
        CHECK(plc.log().writes_outside(kCellInputs).empty());
      }
    }
  }
}

TEST_CASE("The paper's cell closes the loop with every family") {
  const std::vector<std::pair<PlcFamily, std::string>> families = {{PlcFamily::q, "family=q"},
                                                                   {PlcFamily::l, "family=l"},
                                                                   {PlcFamily::fx5, "family=fx5"},
                                                                   {PlcFamily::iqr, "family=iqr&commands=iqr"}};
  for (const auto& [family, parameters] : families) {
    CAPTURE(parameters);
    SlmpPlc plc(cell_plc(family));
    link::LinkSettings settings;
    settings.arm = true;
    CellClient client(plc.port(), parameters + "&events=direct&poll=1ms", settings);
    const bool finished = finishes(plc, 2);
    INFO(client.messages());
    CHECK(finished);
    CHECK(plc.log().writes_outside(kCellInputs).empty());
  }
}

TEST_CASE("Each strategy for events reaches the program") {
  const auto runs = [](const std::string& parameters, test::CellInputs inputs, const DeviceRange& window) {
    CAPTURE(parameters);
    PlcOptions options = cell_plc();
    options.program = [inputs](PlcMemory& memory) { test::scan_cell(memory, inputs); };
    SlmpPlc plc(options);
    const CellClient client(plc.port(), "family=iqr&poll=1ms&" + parameters);
    CHECK(finishes(plc, 2));
    CHECK(plc.log().violations().empty());
    CHECK(plc.log().writes_outside({window}).empty());
  };
  runs("events=direct", {"X", 0}, {"X", 1, 4});
  runs("events=dx", {"X", 0}, {"DX", 1, 4});
  runs("map=X0-X3F:X800", {"X", 0x800}, {"X", 0x801, 4});
  runs("map=X0-XF:M1000", {"M", 1000}, {"M", 1001, 4});
  runs("map=X0-XF:B20", {"B", 0x20}, {"B", 0x21, 4});
  runs("map=X0-XF:D100", {"D", 100}, {"D", 100, 1});
}

TEST_CASE("A link that cannot identify the PLC reads, but writes only when it is armed") {
  SlmpPlc plc(cell_plc(PlcFamily::q));
  {
    CellClient client(plc.port(), "family=q&events=direct&poll=1ms");
    CHECK(soon(plc, [&] { return client.state() == LinkState::live; }));
    CHECK(soon(plc, [&] { return plc.log().count() > 50; }));
    CHECK_FALSE(client.link().status().armed);
    CHECK_THAT(client.messages(), ContainsSubstring("not armed, writes nothing") && ContainsSubstring("--arm"));
  }
  CHECK(plc.log().writes().empty());
  link::LinkSettings armed;
  armed.arm = true;
  CHECK(soon(plc, [&] { return plc.connections() == 0; }));
  CellClient client(plc.port(), "family=q&events=direct&poll=1ms", armed);
  CHECK(finishes(plc, 1));
  CHECK(client.link().status().armed);
}

TEST_CASE("A link never writes to a PLC of another family") {
  SlmpPlc plc(cell_plc(PlcFamily::iqr));
  link::LinkSettings armed;
  armed.arm = true;
  CellClient client(plc.port(), "family=q&events=direct&poll=1ms", armed);
  CHECK(soon(plc, [&] { return plc.log().count() > 50; }));
  CHECK(plc.log().writes().empty());
  CHECK_THAT(client.messages(), ContainsSubstring("its CPU is `R08CPU`") && ContainsSubstring("set family=iqr"));
}

TEST_CASE("Inputs that the PLC's input module overwrites are reported") {
  PlcOptions options = cell_plc();
  options.refreshed = {{"X", 0, 16}};
  SlmpPlc plc(options);
  CellClient client(plc.port(), "family=iqr&events=direct&poll=1ms&read-back=5ms&refresh=10ms");
  CHECK(soon(plc, [&] { return client.overwritten() >= 2; }));  // X1 and X3 are on
}

TEST_CASE("Inputs that stay as they were written are not reported") {
  SlmpPlc plc(cell_plc());
  CellClient client(plc.port(), "family=iqr&events=direct&poll=1ms&read-back=2ms");
  CHECK(finishes(plc, 3));
  CHECK(client.overwritten() == 0);
}

TEST_CASE("After a loss of the PLC everything is written again") {
  SlmpPlc plc(cell_plc());
  CellClient client(plc.port(), "family=iqr&events=direct&poll=1ms&timeout=300ms&timer=250ms", {}, test::kGetsLost);
  CHECK(finishes(plc, 1));
  plc.set_silent(true);
  CHECK(soon(plc, [&] { return client.state() == LinkState::lost; }));
  for (std::uint32_t x = 0; x < 16; ++x) plc.memory().set_bit("X", x, false);
  plc.memory().set_word("D", 10, 0);
  plc.set_silent(false);
  plc.close_connections(true);
  const std::uint16_t before = plc.memory().word("D", 0);
  CHECK(finishes(plc, static_cast<std::uint16_t>(before + 1)));
  CHECK(soon(plc, [&] { return client.state() == LinkState::live; }));
}

TEST_CASE("A PLC whose inputs are cleared gets them again within the refresh") {
  PlcOptions options = cell_plc();
  options.clears_x_at_run_change = true;
  SlmpPlc plc(options);
  const CellClient client(plc.port(), "family=iqr&events=direct&poll=1ms&refresh=20ms&read-back=0s");
  CHECK(finishes(plc, 1));
  plc.set_running(false);
  plc.set_running(true);
  const std::uint16_t before = plc.memory().word("D", 0);
  CHECK(finishes(plc, static_cast<std::uint16_t>(before + 2)));
}

TEST_CASE("A port without online change is explained") {
  PlcOptions options = cell_plc();
  options.writes_in_run = false;
  SlmpPlc plc(options);
  CellClient client(plc.port(), "family=iqr&events=direct&poll=1ms");
  CHECK(soon(plc, [&] { return client.link().status().exceptions != 0; }));
  CHECK(soon(plc, [&] { return client.messages().find("Enable online change") != std::string::npos; }));
  CHECK(soon(plc, [&] { return client.state() == LinkState::live; }));
  plc.set_writes_in_run(true);
  CHECK(finishes(plc, 1));
}

TEST_CASE("A rejected reading is explained, and the rest goes on") {
  SlmpPlc plc;  // without a program, which would need Y
  plc.memory().configure("Y", 0);
  CellClient client(plc.port(), "family=iqr&events=direct&poll=1ms");
  CHECK(soon(plc, [&] { return client.messages().find("rejects reading Y0") != std::string::npos; }));
  CHECK(client.state() == LinkState::waiting);
  CHECK(plc.log().writes().empty());
}

TEST_CASE("A PLC without block access or batches of bits gets other requests") {
  PlcOptions options = cell_plc();
  options.profile.has_blocks = false;
  options.profile.has_bit_batches = false;
  SlmpPlc plc(options);
  CellClient client(plc.port(), "family=iqr&events=direct&poll=1ms&refresh=10ms");
  CHECK(finishes(plc, 2));
  const std::size_t rejected = client.link().status().exceptions;
  CHECK(finishes(plc, 4));
  CHECK(client.link().status().exceptions == rejected);
}

TEST_CASE("At the end the events keep their values, or become 0") {
  for (const bool zero : {false, true}) {
    SlmpPlc plc(cell_plc());
    CellClient client(plc.port(), std::string("family=iqr&events=direct&poll=1ms") + (zero ? "&at-end=zero" : ""));
    CHECK(finishes(plc, 1));
    plc.set_running(false);
    client.link().leave();
    CHECK(soon(plc, [&] { return !client.link().status().end_unread; }));
    bool any = false;
    for (std::uint32_t x = 1; x <= 4; ++x) any = any || plc.memory().bit("X", x);
    CHECK(any == !zero);
  }
}
