// Generated code of a random plant equals the plant of its run-time tables: the same hash, the same traces.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "draw_generated.hpp"
#include "generated_plants.hpp"
#include "lower/lower.hpp"
#include "property/compare.hpp"
#include "property/dice.hpp"
#include "property/engine_plant.hpp"
#include "support/catch.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::property {
namespace {

/// Advances a plant to a time, or through many instants: plants whose instants follow each other within
/// nanoseconds would run forever.
void bring_to(EnginePlant& it, tables::Time target) {
  for (int i = 0; i < 300; ++i) {
    const tables::Time due = it.plant().next_due();
    it.advance_to(std::min(due, target), true);
    if (due >= target) return;
  }
}

/// Writes and waits, the same for plants of the same symbols.
std::vector<reference::InstantRecord> trace_of(const tables::PlantTables& tables, std::uint64_t seed) {
  EnginePlant it(tables, {});
  Dice dice(seed);
  it.plant().reset(seed);
  it.advance_to(0, true);
  for (int step = 0; step < 300; ++step) {
    const auto symbol = static_cast<std::uint32_t>(dice.below(tables.symbols.size()));
    if (tables.symbols[symbol].direction() == tables::Direction::operation) {
      it.write(symbol, dice.below(2));
    } else {
      it.plant().set_input(symbol, dice.below(2));
    }
    bring_to(it, it.plant().now() + static_cast<tables::Time>(dice.below(4)) * 5 * tables::kMillisecond);
  }
  return it.instants();
}

bool same(const std::vector<reference::InstantRecord>& a, const std::vector<reference::InstantRecord>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.time == y.time && x.changes == y.changes && x.findings == y.findings && x.values == y.values;
  });
}

TEST_CASE("Generated code of random plants has the hash of the tables made at run time") {
  CHECK(generated_plants().size() == 50);
  for (const GeneratedPlant& generated : generated_plants()) {
    INFO("seed " << generated.seed);
    const DrawnPlant drawn = draw_generated(generated.seed);
    const lower::EngineTables tables = lower::lower(drawn.model);
    CHECK(tables::model_hash(generated.tables) == tables::model_hash(tables.tables()));
  }
}

TEST_CASE("Generated code of random plants does what the tables made at run time do") {
  std::size_t changes = 0;
  for (const GeneratedPlant& generated : generated_plants()) {
    INFO("seed " << generated.seed);
    const DrawnPlant drawn = draw_generated(generated.seed);
    const lower::EngineTables tables = lower::lower(drawn.model);
    const tables::PlantTables rows = tables.tables();
    const auto trace = trace_of(generated.tables, generated.seed);
    CHECK(same(trace, trace_of(rows, generated.seed)));
    for (const auto& instant : trace) changes += instant.changes.size();
  }
  CHECK(changes > 5000);
}

TEST_CASE("Generated code of random plants does what the reference does") {
  for (const GeneratedPlant& generated : generated_plants()) {
    INFO("seed " << generated.seed);
    const DrawnPlant drawn = draw_generated(generated.seed);
    reference::Counters counters;
    RunCounts counts;
    const auto difference =
        run_case(drawn.model, generated.tables, random_stimulus(generated.seed, drawn.model), false, counters, counts);
    CHECK((difference ? difference->text : "") == "");
  }
}

}  // namespace
}  // namespace symplant::property
