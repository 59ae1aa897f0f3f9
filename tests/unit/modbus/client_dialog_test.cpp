// The conversation of a Modbus client link with a PLC: what it reads, writes, and does with exceptions.

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

TEST_CASE("Operations are read over gaps in one request for each area") {
  ModbusPlc plc;
  plc.with([](PlcMemory& memory) {
    memory.coils[5] = memory.coils[900] = 1;
    memory.holding_registers[20] = 0x1234;
    memory.holding_registers[21] = 0x5678;
  });
  SymbolList list;
  add_bits(list, kOperation, {5, 6, 900});
  list.add("SPEED", kOperation, 10, DataType::dint);
  DialogBench bench(list, plc.port(), "");
  REQUIRE_FALSE(bench.dialog().open());
  REQUIRE_FALSE(bench.read());
  CHECK(sent(plc) == Texts{"1:5+896", "3:20+2"});
  CHECK(bench.bit(5));
  CHECK_FALSE(bench.bit(6));
  CHECK(bench.bit(900));
  CHECK(bench.number(20) == 0x1234);
  CHECK(bench.number(21) == 0x5678);
}

TEST_CASE("Packed operations and numbers of one area are read by one request, in either order of bits") {
  for (const bool high_first : {false, true}) {
    ModbusPlc plc;
    plc.with([&](PlcMemory& memory) {
      memory.input_registers[101] = high_first ? 0x8000 : 0x0001;  // number 16
      memory.input_registers[110] = 77;
    });
    SymbolList list;
    add_bits(list, kOperation, {2, 16, 17});
    list.add("SPEED", kOperation, 4, DataType::int_);
    DialogBench bench(list, plc.port(),
                      std::string("operations=input-registers:100&operation-values=input-registers:106&bit-order=") +
                          (high_first ? "high-first" : "low-first"));
    REQUIRE_FALSE(bench.dialog().open());
    REQUIRE_FALSE(bench.read());
    CHECK(sent(plc) == Texts{"4:100+11"});
    CHECK(bench.bit(16));
    CHECK_FALSE(bench.bit(17));
    CHECK_FALSE(bench.bit(2));
    CHECK(bench.number(4) == 77);
  }
}

TEST_CASE("A request over addresses that the PLC does not have is divided from then on") {
  ModbusPlc plc({.memory = [] {
    PlcMemory memory;
    memory.coils[3] = memory.coils[9] = 1;
    memory.holes = {{PlcArea::coils, 6}};
    return memory;
  }()});
  SymbolList list;
  add_bits(list, kOperation, {3, 4, 9});
  DialogBench bench(list, plc.port(), "");
  REQUIRE_FALSE(bench.dialog().open());
  REQUIRE_FALSE(bench.read());
  CHECK(sent(plc) == Texts{"1:3+7", "1:3+2", "1:9+1"});
  CHECK(bench.bit(3));
  CHECK(bench.bit(9));
  REQUIRE_FALSE(bench.read());
  CHECK(sent(plc) == Texts{"1:3+2", "1:9+1"});
  CHECK(bench.dialog().take_rejections().empty());
}

TEST_CASE("A mapped address that the PLC does not have is found, reported, tried again rarely, and the rest goes on") {
  ModbusPlc plc;
  SymbolList list;
  add_bits(list, kOperation, {3, 4, 999, 1000, 1001});
  DialogBench bench(list, plc.port(), "");
  REQUIRE_FALSE(bench.dialog().open());
  REQUIRE_FALSE(bench.read());
  CHECK(sent(plc) == Texts{"1:3+999", "1:3+2", "1:999+3"});
  const auto rejections = bench.dialog().take_rejections();
  REQUIRE(rejections.size() == 1);
  CHECK_THAT(rejections.front().message,
             ContainsSubstring("rejects reading coils 999-1001") && ContainsSubstring("exception 02"));
  bool whole = true;
  const auto pass = [&](tables::Time now) {
    whole = !bench.read(now);
    return sent(plc);
  };
  CHECK(pass(10) == Texts{"1:3+2", "1:999+3", "1:999+1", "1:1000+2", "1:1000+1"});
  CHECK_FALSE(whole);  // it is not known whether the PLC has coil 1001
  CHECK(pass(20) == Texts{"1:3+2", "1:999+1", "1:1001+1"});
  CHECK(whole);
  CHECK(bench.dialog().take_left_out().empty());
  std::size_t refused = 0;
  for (tables::Time now = 1; now < 100; ++now) refused += pass(now * tables::kSecond).size() - 2;
  CHECK(refused < 40);
  const auto left_out = bench.dialog().take_left_out();
  REQUIRE(left_out.size() == 2);
  CHECK(left_out[0].lanes.lane == link::client::Lane{link::Plane::operation_bits, 62});
  CHECK(left_out[0].lanes.mask == 0x0100);
  CHECK(left_out[1].lanes.mask == 0x0200);
  CHECK(left_out[0].refusal == tables::Refusal{tables::Refusal::Side::modbus_client, 1, 2, 1000});
  CHECK(bench.dialog().take_rejections().empty());
  plc.with([](PlcMemory& memory) { memory.coils.resize(2000, 1); });
  pass(200 * tables::kSecond);
  CHECK(bench.bit(1000));
  CHECK(bench.bit(1001));
  CHECK(pass(300 * tables::kSecond) == Texts{"1:3+999"});  // whole again
}

TEST_CASE("If the PLC rejects all, so is the reading") {
  ModbusPlc plc({.abilities = {.functions = {43}}});
  SymbolList list;
  add_bits(list, kOperation, {3});
  DialogBench bench(list, plc.port(), "");
  REQUIRE_FALSE(bench.dialog().open());
  CHECK(bench.read().kind == Fault::Kind::rejected);
  CHECK_THAT(bench.dialog().take_rejections().front().message,
             ContainsSubstring("coil 3:") && ContainsSubstring("does not support function 1"));
}

TEST_CASE("A busy PLC is asked again at once") {
  ModbusPlc plc({.abilities = {.busy = 1}});
  SymbolList list;
  add_bits(list, kOperation, {3});
  DialogBench bench(list, plc.port(), "");
  REQUIRE_FALSE(bench.dialog().open());
  CHECK(bench.read().kind == Fault::Kind::rejected);
  CHECK_FALSE(bench.read());
}

TEST_CASE("Changed coils between others are joined, and no address without a symbol is written") {
  ModbusPlc plc;
  SymbolList list;
  add_bits(list, kEvent, {1, 2, 3, 14, 15, 16, 17, 40});
  DialogBench bench(list, plc.port(), "events=coils:100");
  REQUIRE_FALSE(bench.dialog().open());
  REQUIRE_FALSE(bench.write());
  CHECK(sent(plc) == Texts{"15:101+3", "15:114+4", "15:140+1"});
  bench.set_bit(1, true);
  bench.set_bit(3, true);
  bench.set_bit(14, true);
  bench.set_bit(17, true);
  REQUIRE_FALSE(bench.write());
  CHECK(sent(plc) == Texts{"15:101+3", "15:114+4"});
  plc.with([](PlcMemory& memory) {
    CHECK(std::vector<int>(memory.coils.begin() + 100, memory.coils.begin() + 104) == std::vector<int>{0, 1, 0, 1});
    CHECK(std::vector<int>(memory.coils.begin() + 114, memory.coils.begin() + 118) == std::vector<int>{1, 0, 0, 1});
  });
  REQUIRE_FALSE(bench.write());
  CHECK(sent(plc).empty());
}

TEST_CASE("A register with some mapped bits is written whole, with zeros in the others") {
  for (const bool high_first : {false, true}) {
    ModbusPlc plc;
    plc.with([](PlcMemory& memory) { memory.holding_registers[200] = 0xFFFF; });
    SymbolList list;
    add_bits(list, kEvent, {1, 4, 20});
    DialogBench bench(
        list, plc.port(),
        std::string("events=holding-registers:200&bit-order=") + (high_first ? "high-first" : "low-first"));
    REQUIRE_FALSE(bench.dialog().open());
    bench.set_bit(0, true);  // not mapped
    bench.set_bit(4, true);
    bench.set_bit(20, true);
    REQUIRE_FALSE(bench.write());
    CHECK(sent(plc) == Texts{"16:200+2"});
    plc.with([&](PlcMemory& memory) {
      CHECK(memory.holding_registers[200] == (high_first ? 0x0800 : 0x0010));
      CHECK(memory.holding_registers[201] == (high_first ? 0x0800 : 0x0010));
    });
    std::vector<std::uint64_t> bits(4);
    std::vector<std::uint64_t> numbers(4);
    REQUIRE_FALSE(bench.read_back(bits, numbers));
    CHECK(bits[0] == 0x10'0010);
  }
}

TEST_CASE("A number is never divided between two requests") {
  ModbusPlc plc;
  SymbolList list;
  for (std::uint32_t i = 0; i < 70; ++i) list.add("N" + std::to_string(i), kEvent, i, DataType::dint);
  for (std::uint32_t i = 0; i < 70; ++i) list.add("S" + std::to_string(i), kOperation, i, DataType::dint);
  DialogBench bench(list, plc.port(), "event-values=holding-registers:500");
  REQUIRE_FALSE(bench.dialog().open());
  REQUIRE_FALSE(bench.write());
  CHECK(sent(plc) == Texts{"16:500+122", "16:622+18"});
  REQUIRE_FALSE(bench.read());
  CHECK(sent(plc) == Texts{"3:0+124", "3:124+16"});
  bench.set_number(3, 1);
  bench.set_number(4, 1);
  REQUIRE_FALSE(bench.write());
  CHECK(sent(plc) == Texts{"16:503+2"});
}

TEST_CASE("A rejected write is explained, and its changes are returned") {
  ModbusPlc plc({.abilities = {.functions = {1, 3, 16}}});
  SymbolList list;
  add_bits(list, kEvent, {3});
  DialogBench bench(list, plc.port(), "events=coils");
  REQUIRE_FALSE(bench.dialog().open());
  CHECK_FALSE(bench.write());
  CHECK_THAT(
      bench.dialog().take_rejections().front().message,
      ContainsSubstring("rejects writing coil 3: exception 01") && ContainsSubstring("neither function 15 nor 5"));
  REQUIRE(bench.unwritten().size() == 1);
  CHECK(bench.unwritten()[0].change.mask == 8);
  CHECK(bench.unwritten()[0].refusal == tables::Refusal{tables::Refusal::Side::modbus_client, 5, 1, 3});
}

TEST_CASE("A PLC is identified by function 43, and always unverifiable") {
  ModbusPlc plc;
  SymbolList list;
  add_bits(list, kOperation, {3});
  add_bits(list, kEvent, {5});
  DialogBench bench(list, plc.port(), "events=coils");
  REQUIRE_FALSE(bench.dialog().open());
  Fault fault;
  auto identity = bench.dialog().identify(fault);
  CHECK_FALSE(fault);
  CHECK(identity.kind == link::client::Identity::Kind::unverifiable);
  CHECK_THAT(identity.message, ContainsSubstring("the PLC is `Test PLC`; its operations can be read"));
  plc.with_abilities([](auto& abilities) { abilities.functions = {15}; });
  identity = bench.dialog().identify(fault);
  CHECK_FALSE(fault);
  CHECK_THAT(identity.message,
             ContainsSubstring("does not identify itself") && ContainsSubstring("its operations cannot be read"));
}

TEST_CASE("A PLC that does not answer function 43 is not asked again") {
  ModbusPlc plc({.abilities = {.silent_functions = {43}}});
  SymbolList list;
  add_bits(list, kOperation, {3});
  DialogBench bench(list, plc.port(), "timeout=300ms");
  REQUIRE_FALSE(bench.dialog().open());
  for (int time = 0; time < 2; ++time) {
    Fault fault;
    CHECK_THAT(bench.dialog().identify(fault).message, ContainsSubstring("does not identify itself"));
    CHECK_FALSE(fault);
  }
  const std::vector<PlcBytes> requests = plc.requests();
  CHECK(std::count_if(requests.begin(), requests.end(), [](const PlcBytes& pdu) { return pdu[0] == 43; }) == 1);
  CHECK(plc.accepted() == 2);
}

TEST_CASE("An interruption ends a wait for an answer") {
  ModbusPlc plc({.abilities = {.silent_functions = {1}}});
  SymbolList list;
  add_bits(list, kOperation, {3});
  DialogBench bench(list, plc.port(), "timeout=60s");
  REQUIRE_FALSE(bench.dialog().open());
  bench.dialog().interrupt();
  CHECK(bench.read().kind == Fault::Kind::interrupted);
}
