// Recording PLCs that serve Modbus and SLMP on this machine.
#include "record/recorder.hpp"

#include <chrono>
#include <fstream>
#include <thread>

#include "recording/read.hpp"
#include "support/catch.hpp"
#include "support/modbus/modbus_plc.hpp"
#include "support/slmp/slmp_plc.hpp"
#include "symplant/link/client_parts.hpp"
#include "unit/record/record_support.hpp"

using namespace symplant;
using test::kMillisecond;
using test::modbus::ModbusPlc;
using test::modbus::PlcMemory;
using test::slmp::SlmpPlc;

namespace {

using std::chrono::milliseconds;

/// A recording of three_symbols(), to a file.
class RecordingBench {
 public:
  RecordingBench(const std::string& url, test::Time every)
      : tables_(list_.tables()), names_(tables_), parts_(made(url)) {
    record::What what;
    what.link = url;
    what.every = every;
    what.utc = [](test::Time /*time*/) { return std::string("1970-01-01T00:00:00Z"); };
    writer_.emplace(trace::OutputFile("recording", path()), names_, std::move(what));
    recorder_.emplace(parts_, tables_, every, *writer_);
  }

  record::Recorder& recorder() { return *recorder_; }
  record::Writer& writer() { return *writer_; }
  std::string path() const { return folder_ / "r.jsonl"; }

  template <class Holds>
  bool wait(Holds holds) {
    for (int i = 0; i < 2'000 && !holds(); ++i) std::this_thread::sleep_for(milliseconds(10));
    return holds();
  }
  recording::ReadRecording read() const {
    std::ifstream file(path());
    return recording::read_recording(file, "r");
  }
  std::size_t count(const std::string& text) const {
    const std::string file = test::read_bytes(path());
    std::size_t count = 0;
    for (std::size_t at = file.find(text); at != file.npos; at = file.find(text, at + 1)) ++count;
    return count;
  }

 private:
  link::client::ClientParts made(const std::string& url) const {
    link::LinkChoice choice{url, 0};
    choice.settings.reads_only = true;
    auto parts = link::client_parts(choice, tables_);
    if (auto* error = std::get_if<link::LinkError>(&parts)) throw std::runtime_error(error->message);
    return std::get<link::client::ClientParts>(std::move(parts));
  }

  test::TemporaryFolder folder_;
  test::SymbolList list_ = test::three_symbols();
  tables::PlantTables tables_;
  trace::PlantNames names_;
  link::client::ClientParts parts_;
  std::optional<record::Writer> writer_;
  std::optional<record::Recorder> recorder_;
};

std::string modbus_url(const ModbusPlc& plc) {
  return "modbus-tcp://127.0.0.1:" + std::to_string(plc.port()) + "?timeout=2s&retry=20ms";
}

}  // namespace

TEST_CASE("Every change of a Modbus PLC is recorded, and nothing is written to it") {
  ModbusPlc plc;
  RecordingBench bench(modbus_url(plc), 5 * kMillisecond);
  REQUIRE(bench.wait([&] { return bench.recorder().state().has_started; }));
  for (std::uint64_t i = 1; i <= 20; ++i) {
    plc.with([&](PlcMemory& memory) {
      memory.coils[0] = static_cast<std::uint16_t>(i % 2);
      memory.input_registers[0] = static_cast<std::uint16_t>(i);
    });
    REQUIRE(bench.wait([&] { return bench.recorder().state().changes >= 2 * i; }));
  }
  bench.recorder().stop();
  const auto read = bench.read();
  CHECK(read.error.empty());
  CHECK(read.warnings.empty());
  REQUIRE(read.recording.series.size() == 3);
  CHECK(bench.writer().state().changes == 40);
  CHECK(plc.written().empty());
  for (const auto& request : plc.requests()) CHECK((request[0] <= 4 || request[0] == 43));
}

TEST_CASE("A connection that comes and goes gives gaps, and the recording goes on") {
  ModbusPlc plc;
  RecordingBench bench(modbus_url(plc), 5 * kMillisecond);
  REQUIRE(bench.wait([&] { return bench.recorder().state().has_started; }));
  for (std::uint64_t i = 1; i <= 5; ++i) {
    plc.close_connections();
    REQUIRE(bench.wait([&] { return bench.recorder().state().gaps >= i; }));
    plc.with([&](PlcMemory& memory) { memory.coils[0] = static_cast<std::uint16_t>(i % 2); });
    REQUIRE(bench.wait([&] { return bench.recorder().state().changes >= i; }));
  }
  bench.recorder().stop();
  CHECK(bench.read().error.empty());
  CHECK(bench.count("\"gap\":") == bench.writer().state().gaps);
  CHECK(plc.written().empty());
}

TEST_CASE("A PLC that lies is recorded with its gaps, and only with true values") {
  test::modbus::PlcSetup setup;
  setup.memory.coils[0] = 1;
  setup.memory.input_registers[0] = 0x5A5A;
  ModbusPlc plc(setup);
  RecordingBench bench("modbus-tcp://127.0.0.1:" + std::to_string(plc.port()) + "?timeout=30ms&retry=1ms",
                       2 * kMillisecond);
  REQUIRE(bench.wait([&] { return bench.recorder().state().has_started; }));
  plc.lie({.seed = 3, .per_thousand = 300});
  REQUIRE(bench.wait([&] { return plc.lies() > 100; }));
  plc.lie({});
  const auto images = bench.recorder().meter().images.value();
  REQUIRE(bench.wait([&] { return bench.recorder().meter().images.value() > images + 5; }));
  bench.recorder().stop();
  CHECK(bench.read().error.empty());
  CHECK(bench.writer().state().changes == 0);  // a wrong value would be one
  CHECK(bench.writer().state().gaps > 10);
  CHECK(plc.written().empty());
}

TEST_CASE("An SLMP PLC is recorded, with a gap where it was away, and nothing is written to it") {
  SlmpPlc plc;
  RecordingBench bench("slmp://127.0.0.1:" + std::to_string(plc.port()) +
                           "?family=iqr&timeout=2s&retry=20ms&map=O:Y0&map=I:X10&map=N:D5",
                       5 * kMillisecond);
  REQUIRE(bench.wait([&] { return bench.recorder().state().has_started; }));
  plc.memory().set_bit("X", 0x10, true);
  REQUIRE(bench.wait([&] { return bench.recorder().state().changes >= 1; }));
  plc.refuse_connections(true);
  plc.close_connections();
  REQUIRE(bench.wait([&] { return bench.recorder().state().is_lost; }));
  plc.memory().set_word("D", 5, 77);
  plc.refuse_connections(false);
  REQUIRE(bench.wait([&] { return bench.recorder().state().changes >= 2; }));
  bench.recorder().stop();
  CHECK(bench.read().error.empty());
  CHECK(bench.count("\"gap\":") >= 1);  // a busy machine may add one
  CHECK(bench.count("\"gap\":") == bench.writer().state().gaps);
  CHECK(bench.count(R"("symbol":"N","value":77)") == 1);
  CHECK(plc.log().writes().empty());
  CHECK(plc.log().violations().empty());
}

TEST_CASE("A recording that is ended while the PLC is silent ends at once, with a gap") {
  SlmpPlc plc;
  RecordingBench bench(
      "slmp://127.0.0.1:" + std::to_string(plc.port()) + "?family=iqr&timeout=60s&map=O:Y0&map=I:X10&map=N:D5",
      5 * kMillisecond);
  REQUIRE(bench.wait([&] { return bench.recorder().state().has_started; }));
  plc.set_silent(true);
  std::this_thread::sleep_for(milliseconds(200));
  bench.recorder().stop();
  CHECK(bench.count("\"gap\":") >= 1);
  CHECK(bench.count("\"end\":true") == 1);
}
