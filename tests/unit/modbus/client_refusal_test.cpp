// What a Modbus client does with a PLC that refuses, lacks functions, or closes its connections.

#include "support/catch.hpp"
#include "support/modbus/modbus_plc.hpp"
#include "unit/modbus/dialog_bench.hpp"
#include "unit/modbus/sent.hpp"

using namespace symplant;
using Catch::Matchers::ContainsSubstring;
using link::client::Fault;
using link::modbus::Table;
using tables::DataType;
using test::add_bits;
using test::DialogBench;
using test::kEvent;
using test::kOperation;
using test::sent;
using test::SymbolList;
using test::Texts;
using test::modbus::ModbusPlc;
using test::modbus::PlcArea;
using test::modbus::PlcMemory;
using PlcBytes = test::modbus::Bytes;

TEST_CASE("A request that the PLC refuses once is sent again in the next pass, whatever the exception is") {
  for (const int exception : {1, 2, 3, 4, 5, 6, 7, 8, 10, 11, 255}) {
    const auto code = static_cast<std::uint8_t>(exception);
    CAPTURE(exception);
    ModbusPlc plc({.abilities = {.exceptions = {code}}});
    SymbolList list;
    add_bits(list, kOperation, {3, 4});
    DialogBench bench(list, plc.port(), "");
    REQUIRE_FALSE(bench.dialog().open());
    CHECK(bench.read(0).kind == Fault::Kind::rejected);
    CHECK(bench.dialog().take_rejections().size() == 1);
    CHECK_FALSE(bench.read(1));
    CHECK(bench.dialog().take_rejections().empty());
    CHECK(sent(plc) == Texts{"1:3+2", "1:3+2"});
  }
}

TEST_CASE("A number stays in one request if the reading is divided") {
  ModbusPlc plc({.memory = [] {
    PlcMemory memory;
    memory.holes = {{PlcArea::holding_registers, 2}};
    return memory;
  }()});
  SymbolList list;
  for (std::uint32_t i = 0; i < 3; ++i) list.add("N" + std::to_string(i), kOperation, i, DataType::dint);
  DialogBench bench(list, plc.port(), "");
  REQUIRE_FALSE(bench.dialog().open());
  for (tables::Time now = 0; now < 10; ++now) {
    bench.read(now);
  }
  for (const std::string& text : sent(plc))
    CHECK_THAT(text, ContainsSubstring("+2") || ContainsSubstring("+4") || ContainsSubstring("+6"));
}

TEST_CASE("A PLC without functions 15 and 16 gets 5 and 6 from then on") {
  ModbusPlc plc({.abilities = {.functions = {1, 2, 3, 4, 5, 6}}});
  SymbolList list;
  add_bits(list, kEvent, {1, 2, 3});
  list.add("N", kEvent, 20, DataType::int_);
  list.add("M", kEvent, 21, DataType::int_);
  DialogBench bench(list, plc.port(), "events=coils:800&event-values=holding-registers:100");
  REQUIRE_FALSE(bench.dialog().open());
  bench.set_bit(2, true);
  bench.set_number(20, 0x1234);
  REQUIRE_FALSE(bench.write());
  CHECK(bench.unwritten().empty());
  CHECK(bench.dialog().take_rejections().empty());
  CHECK(sent(plc) == Texts{"15:801+3", "5:801+0", "5:802+65280", "5:803+0", "16:120+2", "6:120+4660", "6:121+0"});
  bench.dialog().close();
  REQUIRE_FALSE(bench.dialog().open());
  bench.set_bit(2, false);
  REQUIRE_FALSE(bench.write());
  CHECK(sent(plc) == Texts{"5:802+0"});
  plc.with([](PlcMemory& memory) {
    CHECK(memory.coils[802] == 0);
    CHECK(memory.holding_registers[120] == 0x1234);
  });
  CHECK_THAT(bench.dialog().functions(),
             ContainsSubstring("15 or 5 to write coils") && ContainsSubstring("it does not have 15, 16"));
}

TEST_CASE("A number of several registers is never written in parts: it is refused where function 16 is missing") {
  ModbusPlc plc({.abilities = {.functions = {3, 6}}});
  SymbolList list;
  list.add("N", kEvent, 20, DataType::int_);
  list.add("M", kEvent, 21, DataType::dint);
  DialogBench bench(list, plc.port(), "event-values=holding-registers");
  REQUIRE_FALSE(bench.dialog().open());
  REQUIRE_FALSE(bench.write());
  REQUIRE(bench.unwritten().size() == 2);
  CHECK(bench.unwritten()[0].change.lane.plane == link::Plane::event_numbers);
  CHECK(bench.unwritten()[0].refusal.function == 16);
  CHECK_THAT(bench.dialog().take_rejections().front().message, ContainsSubstring("use a number of 16 bits"));
  for (const auto& written : plc.written()) CHECK(written.first == 20);
}

TEST_CASE("A PLC that had only the single functions gets the others again if it loses these") {
  ModbusPlc plc({.abilities = {.functions = {1, 5}}});
  SymbolList list;
  add_bits(list, kEvent, {1});
  DialogBench bench(list, plc.port(), "events=coils");
  REQUIRE_FALSE(bench.dialog().open());
  REQUIRE_FALSE(bench.write());
  plc.with_abilities([](auto& abilities) { abilities.functions = {1, 15}; });
  bench.set_bit(1, true);
  REQUIRE_FALSE(bench.write());
  CHECK(bench.unwritten().size() == 1);
  CHECK_THAT(bench.dialog().take_rejections().front().message, ContainsSubstring("neither function 15 nor 5"));
  bench.outbox().restart();
  REQUIRE_FALSE(bench.write());
  CHECK(bench.unwritten().empty());
  plc.with([](PlcMemory& memory) { CHECK(memory.coils[1] == 1); });
}

TEST_CASE("With swapped bytes each register is read and written so, packed bits included") {
  ModbusPlc plc;
  plc.with([](PlcMemory& memory) {
    memory.holding_registers[10] = 0x3412;
    memory.input_registers[0] = 0x0001;
  });
  SymbolList list;
  list.add("N", kOperation, 10, DataType::int_);
  add_bits(list, kOperation, {0, 8});
  list.add("M", kEvent, 20, DataType::int_);
  add_bits(list, kEvent, {1});
  DialogBench bench(list, plc.port(),
                    "operations=input-registers&events=holding-registers:300&event-values=holding-registers:200"
                    "&bytes=swapped");
  REQUIRE_FALSE(bench.dialog().open());
  REQUIRE_FALSE(bench.read());
  CHECK(bench.number(10) == 0x1234);
  CHECK(bench.bit(8));
  CHECK_FALSE(bench.bit(0));
  bench.set_number(20, 0x0102);
  bench.set_bit(1, true);
  REQUIRE_FALSE(bench.write());
  plc.with([](PlcMemory& memory) {
    CHECK(memory.holding_registers[220] == 0x0201);
    CHECK(memory.holding_registers[300] == 0x0200);
  });
}

TEST_CASE("A server that closes after each answer is served, one connection for each request") {
  ModbusPlc plc({.abilities = {.closes_after = 1}});
  SymbolList list;
  add_bits(list, kOperation, {3});
  add_bits(list, kEvent, {1});
  DialogBench bench(list, plc.port(), "events=coils:100");
  REQUIRE_FALSE(bench.dialog().open());
  Fault fault;
  bench.dialog().identify(fault);
  CHECK_FALSE(fault);
  for (int i = 0; i < 5; ++i) {
    plc.with([i](PlcMemory& memory) { memory.coils[3] = i % 2 != 0 ? 1 : 0; });
    bench.set_bit(1, i % 2 == 0);
    REQUIRE_FALSE(bench.read());
    REQUIRE_FALSE(bench.write());
    CHECK(bench.bit(3) == (i % 2 != 0));
    plc.with([i](PlcMemory& memory) { CHECK(memory.coils[101] == (i % 2 == 0 ? 1 : 0)); });
  }
  CHECK(plc.accepted() == plc.requests().size());
}

TEST_CASE("What something else than a Modbus server answers is in the message") {
  ModbusPlc plc;
  plc.lie({.seed = 3, .per_thousand = 1000, .kinds = {test::modbus::Lie::protocol_id}});
  SymbolList list;
  add_bits(list, kOperation, {3});
  DialogBench bench(list, plc.port(), "");
  REQUIRE_FALSE(bench.dialog().open());
  CHECK_THAT(bench.read().message, ContainsSubstring("the answer is not from a Modbus server, the bytes 00 01"));
}

TEST_CASE("A PLC that closes on function 43 is asked for the rest over a new connection") {
  ModbusPlc plc({.abilities = {.closing_functions = {43}}});
  SymbolList list;
  add_bits(list, kOperation, {3});
  DialogBench bench(list, plc.port(), "");
  REQUIRE_FALSE(bench.dialog().open());
  Fault fault;
  CHECK_THAT(bench.dialog().identify(fault).message, ContainsSubstring("its operations can be read"));
  CHECK_FALSE(fault);
}
