// The Modbus client link in closed loop with a PLC.
#include "support/catch.hpp"
#include "support/modbus/modbus_plc.hpp"
#include "unit/link/cell_client.hpp"
#include "unit/link/plant_server.hpp"

using namespace symplant;
using Catch::Matchers::ContainsSubstring;
using exec::LinkState;
using test::LinkedCell;
using test::modbus::ModbusPlc;
using test::modbus::PlcArea;
using test::modbus::PlcMemory;
using PlcSetup = test::modbus::PlcSetup;

namespace {

constexpr std::size_t kStep = 910;    ///< a holding register of the program
constexpr std::size_t kRounds = 911;  ///< finished rounds

using ReadInput = bool (*)(const PlcMemory& memory, std::uint32_t n);
using SetOutput = void (*)(PlcMemory& memory, std::uint32_t n, bool on);

PlcSetup cell_setup(ReadInput x, SetOutput y) {
  PlcSetup setup;
  setup.program = [x, y](PlcMemory& memory) {
    const bool finished = test::run_cell_program(
        memory.holding_registers[kStep], [&](std::uint32_t n) { return x(memory, n); },
        [&](std::uint32_t n, bool on) { y(memory, n, on); });
    if (finished) ++memory.holding_registers[kRounds];
  };
  return setup;
}

bool coil_input(const PlcMemory& memory, std::uint32_t n) { return memory.coils[100 + n] != 0; }
bool packed_input(const PlcMemory& memory, std::uint32_t n) { return (memory.holding_registers[50] >> n & 1) != 0; }
bool reversed_input(const PlcMemory& memory, std::uint32_t n) {
  return (memory.holding_registers[50] >> (15 - n) & 1) != 0;
}
void coil_output(PlcMemory& memory, std::uint32_t n, bool on) { memory.coils[n] = on ? 1 : 0; }
void discrete_output(PlcMemory& memory, std::uint32_t n, bool on) { memory.discrete_inputs[30 + n] = on ? 1 : 0; }
void set_register_bit(std::uint16_t& value, std::uint32_t bit, bool on) {
  value = static_cast<std::uint16_t>((value & ~(1U << bit)) | (on ? 1U << bit : 0U));
}
void packed_output(PlcMemory& memory, std::uint32_t n, bool on) {
  set_register_bit(memory.holding_registers[7], n, on);
}
void reversed_output(PlcMemory& memory, std::uint32_t n, bool on) {
  set_register_bit(memory.input_registers[7], 15 - n, on);
}

link::LinkSettings armed() {
  link::LinkSettings settings;
  settings.arm = true;
  return settings;
}

std::string url_of(const ModbusPlc& plc, const std::string& parameters) {
  return "modbus-tcp://127.0.0.1:" + std::to_string(plc.port()) + "?poll=1ms&retry=1ms&" + parameters;
}

bool finishes_rounds(ModbusPlc& plc, int rounds) {
  return plc.wait_until([rounds](PlcMemory& memory) { return memory.holding_registers[kRounds] >= rounds; });
}

}  // namespace

TEST_CASE("The paper's cell closes the loop through every area of a Modbus server") {
  struct Areas {
    std::string parameters;
    ReadInput x;
    SetOutput y;
    PlcArea written;
    std::size_t first;
    std::size_t last;
  };
  const std::vector<Areas> all = {
      {"events=coils:100", coil_input, coil_output, PlcArea::coils, 101, 104},
      {"operations=discrete-inputs:30&events=holding-registers:50", packed_input, discrete_output,
       PlcArea::holding_registers, 50, 50},
      {"operations=holding-registers:7&events=coils:100", coil_input, packed_output, PlcArea::coils, 101, 104},
      {"operations=input-registers:7&events=holding-registers:50&bit-order=high-first", reversed_input, reversed_output,
       PlcArea::holding_registers, 50, 50},
  };
  for (const Areas& areas : all) {
    CAPTURE(areas.parameters);
    ModbusPlc plc(cell_setup(areas.x, areas.y));
    const LinkedCell cell(url_of(plc, areas.parameters), armed());
    CHECK(finishes_rounds(plc, 2));
    for (const auto& written : plc.written()) {
      CHECK(written.area == areas.written);
      CHECK(written.first >= areas.first);
      CHECK(written.first + written.values.size() <= areas.last + 1);
    }
  }
}

TEST_CASE("The paper's cell closes the loop with a PLC that has only functions 1 to 6") {
  PlcSetup setup = cell_setup(coil_input, coil_output);
  setup.abilities.functions = {1, 2, 3, 4, 5, 6};
  ModbusPlc plc(std::move(setup));
  LinkedCell cell(url_of(plc, "events=coils:100"), armed());
  CHECK(finishes_rounds(plc, 2));
  CHECK(cell.count(tables::FindingKind::request_refused) == 0);
}

TEST_CASE("The paper's cell closes the loop with a PLC that closes after each answer") {
  PlcSetup setup = cell_setup(coil_input, coil_output);
  setup.abilities.closes_after = 1;
  ModbusPlc plc(std::move(setup));
  const LinkedCell cell(url_of(plc, "events=coils:100"), armed());
  CHECK(finishes_rounds(plc, 1));
}

TEST_CASE("Writes that a PLC refuses are a finding, and its symbols are left out") {
  PlcSetup setup = cell_setup(coil_input, coil_output);
  setup.memory.holes = {{PlcArea::coils, 102}};
  ModbusPlc plc(std::move(setup));
  LinkedCell cell(url_of(plc, "events=coils:100"), armed());
  CHECK(plc.wait_until([&](PlcMemory&) { return cell.count(tables::FindingKind::request_refused) > 0; }));
  CHECK(plc.wait_until([&](PlcMemory&) { return cell.count(tables::FindingKind::symbol_left_out) > 0; }));
  CHECK(plc.wait_until([](PlcMemory& memory) { return memory.coils[103] != 0; }));
  CHECK(cell.count(tables::FindingKind::symbol_left_out) == 1);
}

TEST_CASE("A Modbus client link reads, but writes only when it is armed") {
  ModbusPlc plc(cell_setup(coil_input, coil_output));
  LinkedCell cell(url_of(plc, "events=coils:100"));
  CHECK(plc.wait_until([&](PlcMemory&) { return cell.state() == LinkState::live; }));
  CHECK(plc.wait_until([&](PlcMemory&) { return cell.link().status().requests > 50; }));
  CHECK_FALSE(cell.link().status().armed);
  CHECK(plc.written().empty());
  CHECK_THAT(cell.messages(),
             ContainsSubstring("not armed, writes nothing: the PLC is `Test PLC`") && ContainsSubstring("`--arm`"));
}

TEST_CASE("After a loss of the connection a Modbus client writes everything again") {
  ModbusPlc plc(cell_setup(coil_input, coil_output));
  LinkedCell cell(url_of(plc, "events=coils:100&refresh=60s"), armed(), test::kGetsLost);
  CHECK(finishes_rounds(plc, 1));
  plc.with([](PlcMemory& memory) { std::fill(memory.coils.begin() + 100, memory.coils.end(), 0); });
  plc.close_connections();
  int before = 0;
  plc.with([&](PlcMemory& memory) { before = memory.holding_registers[kRounds]; });
  CHECK(finishes_rounds(plc, before + 2));
}

TEST_CASE("Coils that the PLC's program overwrites are reported") {
  PlcSetup setup = cell_setup(coil_input, coil_output);
  setup.program = [](PlcMemory& memory) { memory.coils[101] = 0; };
  ModbusPlc plc(setup);
  LinkedCell cell(url_of(plc, "events=coils:100&read-back=2ms&refresh=5ms"), armed());
  CHECK(plc.wait_until([&](PlcMemory&) { return cell.overwritten() >= 1; }));
}

TEST_CASE("A Modbus client lives through a lying PLC and goes on when the lies end") {
  ModbusPlc plc(cell_setup(coil_input, coil_output));
  plc.lie({.seed = 9, .per_thousand = 100});
  LinkedCell cell(url_of(plc, "events=coils:100&timeout=20ms&refresh=5ms"), armed());
  CHECK(plc.wait_until([&](PlcMemory&) { return plc.lies() > 20; }));
  plc.lie({});
  int before = 0;
  plc.with([&](PlcMemory& memory) { before = memory.holding_registers[kRounds]; });
  CHECK(finishes_rounds(plc, before + 1));
  for (const auto& written : plc.written()) {
    CHECK(written.area == PlcArea::coils);
    CHECK((written.first > 100 && written.first + written.values.size() <= 105));
  }
}

TEST_CASE("At the end a Modbus client leaves the events, or sets them to zero") {
  for (const bool zero : {false, true}) {
    ModbusPlc plc(cell_setup(coil_input, coil_output));
    LinkedCell cell(url_of(plc, std::string("events=coils:100") + (zero ? "&at-end=zero" : "")), armed());
    CHECK(finishes_rounds(plc, 1));
    cell.link().leave();
    CHECK(plc.wait_until([&](PlcMemory&) { return !cell.link().status().end_unread; }));
    plc.with([&](PlcMemory& memory) {
      int on = 0;
      for (std::size_t i = 101; i <= 104; ++i) on += memory.coils[i];
      CHECK((on == 0) == zero);
    });
  }
}

TEST_CASE("A server plant and a client plant exchange their signals") {
  // The server's coils are the operations of its plant: the client's events go there.
  test::CellServer server;
  server.start_cycling();
  LinkedCell client(
      "modbus-tcp://127.0.0.1:" + std::to_string(server.port()) + "?operations=discrete-inputs&events=coils&poll=1ms",
      armed());
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (server.link().status().requests < 100 && std::chrono::steady_clock::now() < deadline)
    std::this_thread::yield();
  CHECK(client.state() == LinkState::live);
  CHECK(client.link().status().exceptions == 0);
  CHECK(client.link().status().armed);
  CHECK_THAT(client.messages(), ContainsSubstring("armed: the PLC is `symplant"));
}

TEST_CASE("A cut Modbus client sends nothing and is lost, afterwards it connects again by itself") {
  ModbusPlc plc(cell_setup(coil_input, coil_output));
  LinkedCell cell(url_of(plc, "events=coils:100"), armed(), test::kGetsLost);
  CHECK(finishes_rounds(plc, 1));
  cell.link().cut(true);
  CHECK(plc.wait_until([&](PlcMemory&) { return cell.link().status().connections == 0; }));
  CHECK(plc.wait_until([&](PlcMemory&) { return cell.state() == LinkState::lost; }));
  const std::uint64_t requests = cell.link().status().requests;
  const auto written = plc.written().size();
  CHECK(plc.wait_until([&](PlcMemory&) { return cell.cycles_lost() > 1000; }));
  CHECK(cell.link().status().requests == requests);
  CHECK(plc.written().size() == written);
  cell.link().cut(false);
  int before = 0;
  plc.with([&](PlcMemory& memory) { before = memory.holding_registers[kRounds]; });
  CHECK(finishes_rounds(plc, before + 1));
}
