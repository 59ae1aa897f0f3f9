// Reading all symbols of a Modbus server without writing.
#include <chrono>
#include <thread>

#include "support/catch.hpp"
#include "support/modbus/modbus_plc.hpp"
#include "symplant/link/client/steady_now.hpp"
#include "symplant/link/client_parts.hpp"
#include "symplant/link/record/image_reader.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;
using Catch::Matchers::ContainsSubstring;
using link::record::ImageReader;
using tables::DataType;
using test::SymbolList;
using test::modbus::ModbusPlc;
using test::modbus::PlcArea;
using test::modbus::PlcMemory;
using PlcSetup = test::modbus::PlcSetup;

namespace {

/// A link that only reads, and its latest image.
class ReadingBench {
 public:
  ReadingBench(const SymbolList& list, std::uint16_t port, const std::string& parameters = "")
      : list_(list),
        tables_(list_.tables()),
        parts_(made(port, parameters)),
        reader_(*parts_.dialog, tables_, parts_.map) {
    REQUIRE_FALSE(parts_.dialog->open());
  }

  link::client::Fault read() { return reader_.read(link::client::steady_now()); }
  const link::record::Reading& of(std::uint32_t symbol) const {
    for (const link::record::Reading& reading : reader_.readings()) {
      if (reading.symbol == symbol) return reading;
    }
    throw std::out_of_range("not mapped");
  }
  link::client::Dialog& dialog() { return *parts_.dialog; }

 private:
  link::client::ClientParts made(std::uint16_t port, const std::string& parameters) const {
    link::LinkChoice choice{"modbus-tcp://127.0.0.1:" + std::to_string(port) + "?timeout=20s&" + parameters, 0};
    choice.settings.reads_only = true;
    auto parts = link::client_parts(choice, tables_);
    if (auto* error = std::get_if<link::LinkError>(&parts)) throw std::runtime_error(error->message);
    return std::get<link::client::ClientParts>(std::move(parts));
  }

  SymbolList list_;
  tables::PlantTables tables_;
  link::client::ClientParts parts_;
  ImageReader reader_;
};

std::string why_not(const SymbolList& list, const std::string& parameters, bool reads_only) {
  link::LinkChoice choice{"modbus-tcp://127.0.0.1:502?" + parameters, 0};
  choice.settings.reads_only = reads_only;
  const auto parts = link::client_parts(choice, list.tables());
  const auto* const error = std::get_if<link::LinkError>(&parts);
  return error == nullptr ? "" : error->message;
}

}  // namespace

TEST_CASE("A link that only reads takes events from the PLC's inputs") {
  SymbolList list;
  const auto out = list.add("O", SymbolList::kOut, 3);
  const auto in = list.add("I", SymbolList::kIn, 5);
  const auto number = list.add("ON", SymbolList::kOut, 7, DataType::int_);
  const auto measured = list.add("IN", SymbolList::kIn, 9, DataType::udint);
  ModbusPlc plc;
  plc.with([](PlcMemory& memory) {
    memory.coils[3] = 1;
    memory.discrete_inputs[5] = 1;
    memory.holding_registers[7] = 0xFFFE;
    memory.input_registers[18] = 1;  // numbers of 32 bits count in steps of 2; high word first
    memory.input_registers[19] = 2;
  });
  ReadingBench bench(list, plc.port());
  REQUIRE_FALSE(bench.read());
  CHECK(bench.of(out).value == 1);
  CHECK(bench.of(in).value == 1);
  CHECK(static_cast<std::int64_t>(bench.of(number).value) == -2);
  CHECK(bench.of(measured).value == 65'538);
  CHECK(plc.written().empty());
}

TEST_CASE("Only a link that reads may have events in inputs") {
  SymbolList list;
  list.add("I", SymbolList::kIn, 5);
  list.add("IN", SymbolList::kIn, 9, DataType::int_);
  const std::string inputs = "events=discrete-inputs:100&event-values=input-registers";
  CHECK(why_not(list, inputs, true).empty());
  CHECK(why_not(list, "events=input-registers:100&event-values=input-registers", true).empty());
  CHECK(why_not(list, "", true).empty());
  CHECK_THAT(why_not(list, inputs, false), ContainsSubstring("the area may be coils, holding-registers"));
  CHECK_THAT(why_not(list, "", false), ContainsSubstring("choose where its program reads events"));
  CHECK_THAT(why_not(list, "event-values=coils", true),
             ContainsSubstring("area may be holding-registers, input-registers"));
}

TEST_CASE("Each request of an image has its own middle, and bits of one request have one time") {
  SymbolList list;
  std::vector<std::uint32_t> symbols;
  // Two requests of coils, since one holds 2,000, and one of discrete inputs.
  for (const std::uint32_t coil : {0U, 1'999U, 2'000U, 2'500U}) {
    symbols.push_back(list.add("O" + std::to_string(coil), SymbolList::kOut, coil));
  }
  symbols.push_back(list.add("I", SymbolList::kIn, 0));
  PlcSetup setup;
  setup.memory.coils.resize(3'000);
  setup.program = [](PlcMemory& /*memory*/) { std::this_thread::sleep_for(std::chrono::milliseconds(3)); };
  ModbusPlc plc(setup);
  ReadingBench bench(list, plc.port());
  const tables::Time before = link::client::steady_now();
  REQUIRE_FALSE(bench.read());
  const tables::Time after = link::client::steady_now();
  CHECK(bench.of(symbols[0]).time == bench.of(symbols[1]).time);
  CHECK(bench.of(symbols[2]).time == bench.of(symbols[3]).time);
  CHECK(bench.of(symbols[0]).time < bench.of(symbols[2]).time);
  CHECK(bench.of(symbols[2]).time < bench.of(symbols[4]).time);
  CHECK(bench.of(symbols[0]).time > before);
  CHECK(bench.of(symbols[4]).time < after);
  CHECK(plc.requests().size() == 3);
}

TEST_CASE("A symbol that the PLC refuses is not read, others are") {
  SymbolList list;
  const auto good = list.add("A", SymbolList::kOut, 3);
  const auto bad = list.add("B", SymbolList::kOut, 40);
  const auto in = list.add("I", SymbolList::kIn, 5);
  PlcSetup setup;
  setup.memory.holes = {{PlcArea::coils, 40}};
  ModbusPlc plc(setup);
  ReadingBench bench(list, plc.port());
  for (int i = 0; i < 10; ++i) REQUIRE_FALSE(bench.read());
  CHECK(bench.of(good).is_read);
  CHECK_FALSE(bench.of(bad).is_read);
  CHECK(bench.of(in).is_read);
  plc.with([](PlcMemory& memory) { memory.holes.clear(); });
  bench.dialog().retry_rejected();
  REQUIRE_FALSE(bench.read());
  CHECK(bench.of(bad).is_read);
}

TEST_CASE("Packed bits and swapped bytes are read as on a link that writes") {
  SymbolList list;
  const auto in = list.add("I", SymbolList::kIn, 18);
  const auto number = list.add("N", SymbolList::kIn, 2, DataType::word);
  ModbusPlc plc;
  plc.with([](PlcMemory& memory) {
    memory.input_registers[101] = 0x0400;  // bit 2 of the swapped register
    memory.holding_registers[302] = 0x1234;
  });
  ReadingBench bench(list, plc.port(), "events=input-registers:100&event-values=holding-registers:300&bytes=swapped");
  REQUIRE_FALSE(bench.read());
  CHECK(bench.of(in).is_read);
  CHECK(bench.of(in).value == 1);
  CHECK(bench.of(number).value == 0x3412);
}
