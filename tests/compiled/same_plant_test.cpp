// A generated plant equals the plant that the same list makes at run time: the same hash, the same traces.
#include <functional>
#include <random>
#include <set>
#include <sstream>
#include <string>

#include "altered_plants.hpp"
#include "app/pipeline.hpp"
#include "app/progress.hpp"
#include "base/file_system.hpp"
#include "compiled_cylinder/plant_gen.hpp"
#include "compiled_excell/plant_gen.hpp"
#include "compiled_mixed/plant_gen.hpp"
#include "compiled_timed/plant_gen.hpp"
#include "support/catch.hpp"
#include "symplant/tables/digest.hpp"
#include "symplant/trace/recorder.hpp"

namespace symplant::test {
namespace {

struct Case {
  std::string list;
  const tables::PlantTables& generated;
};

std::vector<Case> cases() {
  const std::string source = SYMPLANT_SOURCE_DIR;
  return {{source + "/examples/excell/excell.csv", excell::tables()},
          {source + "/examples/cylinder/cylinder.csv", cylinder::tables()},
          {source + "/tests/compiled/mixed.csv", mixed::tables()},
          {source + "/tests/compiled/timed/plant.json", timed::tables()}};
}

app::Compiled compile(const std::string& list) {
  base::DiskFileSystem files;
  diag::Diagnostics diagnostics;
  std::ostringstream err;
  app::Progress progress(err, false);
  auto compiled = app::compile({list, {}, {}}, files, progress, diagnostics);
  REQUIRE(compiled.has_value());
  return std::move(*compiled);
}

using Trace = std::vector<std::tuple<tables::Time, std::uint32_t, std::uint64_t>>;

/// The trace of a plant under random operations, set one by one at random times.
Trace random_trace(const tables::PlantTables& tables, unsigned seed) {
  plant::OwnedPlant plant(tables);
  trace::Recorder recorder(tables, 1 << 16);
  recorder.attach(plant);
  Trace trace;
  std::vector<const tables::SymbolRow*> operations;
  for (const tables::SymbolRow& symbol : tables.symbols) {
    if (symbol.direction() == tables::Direction::operation) operations.push_back(&symbol);
  }
  std::mt19937_64 random(seed);
  tables::Time now = 0;
  plant.advance_to(0, &recorder);
  for (int step = 0; step < 2000; ++step) {
    now += static_cast<tables::Time>(random() % (random() % 2 == 0 ? 400'000'000 : 3'000'000'000));
    const tables::SymbolRow& symbol = *operations[random() % operations.size()];
    if (symbol.type() == tables::DataType::boolean) {
      plant.set_operation(symbol.index, random() % 2 == 0);
    } else {
      plant.set_operation_value(symbol.index, random() % 1000);
    }
    plant.advance_to(now, &recorder);
    recorder.drain([&](const trace::Record& record) {
      if (record.kind == trace::Record::Kind::change) trace.emplace_back(record.time, record.of, record.value);
    });
  }
  CHECK(recorder.lost_changes() == 0);
  return trace;
}

TEST_CASE("A generated plant has the hash of the plant made at run time") {
  for (const Case& c : cases()) {
    INFO(c.list);
    const app::Compiled compiled = compile(c.list);
    CHECK(tables::model_hash(c.generated) == tables::model_hash(compiled.tables.tables()));
    CHECK(c.generated.list_names == compiled.tables.tables().list_names);
    for (std::size_t i = 0; i < c.generated.symbols.size(); ++i) {
      CHECK(c.generated.symbols[i].row == compiled.tables.symbols[i].row);  // in messages, though not in the hash
    }
  }
}

TEST_CASE("A generated plant with one altered row or function has another hash") {
  std::set<std::uint64_t> hashes{tables::model_hash(excell::tables())};
  CHECK(altered_rows().size() == 4);
  CHECK(altered_classes().size() == 6);
  for (const auto& altered : {altered_rows(), altered_classes()}) {
    for (const tables::PlantTables* tables : altered) CHECK(hashes.insert(tables::model_hash(*tables)).second);
  }
}

TEST_CASE("A plant does what the functions of its classes say") {
  const Trace unaltered = random_trace(excell::tables(), 1);
  for (const tables::PlantTables* tables : altered_classes()) CHECK(random_trace(*tables, 1) != unaltered);
}

TEST_CASE("A generated plant does what the plant made at run time does") {
  for (const Case& c : cases()) {
    const app::Compiled compiled = compile(c.list);
    for (const unsigned seed : {1U, 2U, 3U}) {
      INFO(c.list << ", seed " << seed);
      const Trace generated = random_trace(c.generated, seed);
      CHECK(generated.size() > 100);
      CHECK(generated == random_trace(compiled.tables.tables(), seed));
    }
  }
}

}  // namespace
}  // namespace symplant::test
