// The recorder: what it keeps, in which order, and what it does if its ring is full.
#include "symplant/trace/recorder.hpp"

#include <thread>
#include <vector>

#include "support/bare_tables.hpp"
#include "support/catch.hpp"
#include "symplant/plant/owned_plant.hpp"

namespace symplant::test {
namespace {

using tables::AddressForm;
using tables::DataType;
using tables::Direction;

/// Free symbols only: two BOOL operations with rows in reverse order of their bits, and an INT in between.
struct FreePlant {
  std::vector<tables::SymbolRow> symbols{
      {1, tables::kNone, 0, 2, tables::symbol_kind(DataType::boolean, Direction::operation, AddressForm::none, false)},
      {0, tables::kNone, 0, 3, tables::symbol_kind(DataType::int_, Direction::operation, AddressForm::none, false)},
      {0, tables::kNone, 0, 4, tables::symbol_kind(DataType::boolean, Direction::operation, AddressForm::none, false)}};
  tables::PlantTables tables = bare_tables("free", 64, 64, 1, symbols);
  plant::OwnedPlant plant{tables};
};

std::vector<trace::Record> drained(trace::Recorder& recorder) {
  std::vector<trace::Record> changes;
  recorder.drain([&](const trace::Record& change) { changes.push_back(change); });
  return changes;
}

TEST_CASE("Changes within an instant are in the order of the list") {
  FreePlant p;
  trace::Recorder recorder(p.tables, 16);
  recorder.attach(p.plant);
  p.plant.set_operation(0, true);
  p.plant.set_operation_value(0, 7);
  p.plant.set_operation(1, true);
  p.plant.advance_to(5, &recorder);
  const auto changes = drained(recorder);
  REQUIRE(changes.size() == 3);
  for (std::uint32_t i = 0; i < 3; ++i) {
    CHECK(changes[i].of == i);
    CHECK(changes[i].time == 5);
  }
  CHECK(changes[1].value == 7);
  CHECK(drained(recorder).empty());
}

TEST_CASE("Changes that do not fit into the ring are counted, and the first ones are kept") {
  FreePlant p;
  trace::Recorder recorder(p.tables, 4);
  recorder.attach(p.plant);
  for (int i = 1; i <= 10; ++i) {
    p.plant.set_operation(0, i % 2 == 1);
    p.plant.advance_to(i, &recorder);
  }
  const auto changes = drained(recorder);
  REQUIRE(changes.size() == 4);
  CHECK(changes.front().time == 1);
  CHECK(recorder.lost_changes() == 6);
  p.plant.set_operation(0, true);
  p.plant.advance_to(20, &recorder);
  CHECK(drained(recorder).size() == 1);  // there is space again
}

TEST_CASE("An empty ring starts again at its first slot and has room for as many records as before") {
  FreePlant p;
  trace::Recorder recorder(p.tables, 8);
  recorder.attach(p.plant);
  int time = 0;
  for (const std::size_t records : {3U, 8U, 1U, 7U, 8U, 5U}) {
    const int first = time + 1;
    for (std::size_t i = 0; i < records; ++i) {
      ++time;
      p.plant.set_operation(0, time % 2 == 1);
      p.plant.advance_to(time, &recorder);
    }
    const auto changes = drained(recorder);
    REQUIRE(changes.size() == records);
    CHECK(changes.front().time == first);
    CHECK(changes.back().time == time);
  }
  CHECK(recorder.lost_changes() == 0);
}

TEST_CASE("A further instant of a time that changes nothing leaves no record") {
  FreePlant p;
  trace::Recorder recorder(p.tables, 16);
  recorder.attach(p.plant);
  p.plant.set_operation(0, true);
  p.plant.advance_to(5, &recorder);
  CHECK(drained(recorder).size() == 1);
  engine::Instant nothing;
  nothing.time = 5;
  recorder.instant(nothing);
  CHECK(drained(recorder).empty());
  p.plant.set_operation(0, false);
  p.plant.advance_to(6, &recorder);
  CHECK(drained(recorder).size() == 1);
}

TEST_CASE("A thread may drain while the plant runs: every change comes once, in order") {
  FreePlant p;
  trace::Recorder recorder(p.tables, 1 << 12);
  recorder.attach(p.plant);
  std::vector<trace::Record> changes;
  std::jthread reader([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) recorder.drain([&](const trace::Record& change) { changes.push_back(change); });
    recorder.drain([&](const trace::Record& change) { changes.push_back(change); });
  });
  constexpr int kSteps = 200'000;
  for (int i = 1; i <= kSteps; ++i) {
    p.plant.set_operation(0, i % 2 == 1);
    p.plant.advance_to(i, &recorder);
  }
  reader.request_stop();
  reader.join();
  CHECK(changes.size() + recorder.lost_changes() == kSteps);
  for (std::size_t i = 1; i < changes.size(); ++i) {
    if (changes[i].time <= changes[i - 1].time) FAIL("change " << i << " is out of order");
  }
}

}  // namespace
}  // namespace symplant::test
