// The links of a generated plant equal those of the description at run time: the same maps, the same policies.
#include <algorithm>
#include <sstream>

#include "app/pipeline.hpp"
#include "app/progress.hpp"
#include "base/file_system.hpp"
#include "compiled_linked/plant_gen.hpp"
#include "support/catch.hpp"
#include "symplant/link/modbus/io_map.hpp"

namespace symplant::test {
namespace {

app::Compiled compile() {
  base::DiskFileSystem files;
  diag::Diagnostics diagnostics;
  std::ostringstream err;
  app::Progress progress(err, false);
  auto compiled = app::compile({std::string(SYMPLANT_SOURCE_DIR) + "/tests/compiled/linked/plant.json", {}, {}}, files,
                               progress, diagnostics);
  REQUIRE(compiled.has_value());
  return std::move(*compiled);
}

TEST_CASE("Generated links have the maps and policies of the links made at run time") {
  const app::Compiled compiled = compile();
  const tables::PlantTables tables = compiled.tables.tables();
  const auto generated = linked::link_settings();
  REQUIRE(generated.size() == 2);
  REQUIRE(compiled.plant.links.size() == 2);
  std::uint64_t before = 0;
  for (std::uint32_t controller = 0; controller < generated.size(); ++controller) {
    const link::LinkSettings made = compiled.plant.links[controller].settings();
    const link::LinkSettings& own = generated[controller];
    const link::modbus::IoMap map = link::modbus::make_io_map(linked::tables(), controller, own);
    CHECK(map.faults.empty());
    const std::uint64_t hash = link::modbus::map_hash(linked::tables(), map);
    CHECK(hash == link::modbus::map_hash(tables, link::modbus::make_io_map(tables, controller, made)));
    CHECK(hash != link::modbus::map_hash(tables, link::modbus::make_io_map(tables, controller, {})));
    CHECK(hash != before);
    before = hash;

    CHECK(own.word_order == made.word_order);
    CHECK(own.on_loss == made.on_loss);
    CHECK(own.plant_on_loss == made.plant_on_loss);
    CHECK(own.sizes == made.sizes);
    CHECK(own.loss_after == made.loss_after);
    CHECK(own.resync == made.resync);
    CHECK(own.status_block == made.status_block);
    CHECK(own.watchdog == made.watchdog);
    CHECK(own.watchdog_within == made.watchdog_within);
    CHECK(own.clock.symbol == made.clock.symbol);
    CHECK((own.clock.symbol == link::ClockSettings::kNone) == (controller != 0));
    CHECK(own.clock.unit == made.clock.unit);
    CHECK(own.clock.limit == made.clock.limit);
    CHECK(own.connections == made.connections);
    CHECK(own.idle == made.idle);
    CHECK(std::equal(own.keep.begin(), own.keep.end(), made.keep.begin(), made.keep.end()));
    const auto same = [](const link::MapRow& a, const link::MapRow& b) {
      return a.symbol == b.symbol && a.number == b.number && a.word_order == b.word_order && a.on_loss == b.on_loss &&
             a.node == b.node;
    };
    CHECK(std::equal(own.rows.begin(), own.rows.end(), made.rows.begin(), made.rows.end(), same));
  }
}

}  // namespace
}  // namespace symplant::test
