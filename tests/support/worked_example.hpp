// The worked example of docs/model.md, "The paper's cell": PLC commands, the plant's answers, and the states of
// its devices. For any plant made from examples/excell/excell.csv, generated or not.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/trace/recorder.hpp"

namespace symplant::test {

struct ExampleRow {
  tables::Time milliseconds;
  std::vector<std::pair<std::string_view, bool>> writes;
  std::string_view changes;  ///< all net changes, in list order, without EXLINE_MB_: "AGV_I_P1=1 MC_I_IDLE1=1"
  std::string_view agv;
  std::string_view mc;
};

inline std::vector<ExampleRow> worked_example() {
  return {
      {0, {}, "AGV_I_P1=1 MC_I_IDLE1=1", "P1", "IDLE1"},
      {500, {{"AGV_O_P2", true}}, "AGV_I_P1=0 AGV_O_P2=1", "P1->P2", "IDLE1"},
      {700, {{"AGV_O_P2", false}}, "AGV_O_P2=0", "P1->P2", "IDLE1"},
      {1500, {{"MC_O_RUN2", true}}, "AGV_I_P2=1 MC_I_IDLE1=0 MC_O_RUN2=1", "P2", "IDLE1->RUN2"},
      {2500, {}, "MC_I_RUN2=1", "P2", "RUN2"},
      {2600,
       {{"MC_O_RUN2", false}, {"MC_O_IDLE1", true}, {"AGV_O_P1", true}},
       "AGV_I_P2=0 AGV_O_P1=1 MC_I_RUN2=0 MC_O_IDLE1=1 MC_O_RUN2=0",
       "P2->P1",
       "RUN2->IDLE1"},
      {3600, {}, "AGV_I_P1=1 MC_I_IDLE1=1", "P1", "IDLE1"},
  };
}

inline constexpr std::string_view kExamplePrefix = "EXLINE_MB_";

/// The index of a unit by its path; fails the test if there is no such unit.
inline std::uint32_t unit_index(const tables::PlantTables& tables, std::string_view path) {
  const auto names = tables::split_names(tables.unit_names);
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    if (names[i] == path) return i;
  }
  FAIL("no unit " << path);
  return 0;
}

/// "P1", or "P1->P2" while it moves.
inline std::string state_text(const plant::Plant& plant, std::uint32_t unit) {
  const tables::PlantTables& tables = plant.tables();
  std::size_t first = 0;
  for (std::uint32_t type = 0; type < tables.units[unit].type; ++type) first += tables.types[type].states;
  const auto names = tables::split_names(tables.state_names);
  const plant::UnitView view = plant.unit(unit);
  std::string text(names[first + view.state]);
  if (view.moving) text.append("->").append(names[first + view.target]);
  return text;
}

/// Plays the table on a plant at time 0 and checks every change, its time, and every state after it. `seen` receives
/// each change that the recorder returned.
template <class Seen>
void check_worked_example(plant::Plant& plant, Seen seen) {
  const tables::PlantTables& tables = plant.tables();
  const auto names = tables::split_names(tables.symbol_names);
  const std::uint32_t agv = unit_index(tables, "EXLINE_MB_AGV");
  const std::uint32_t mc = unit_index(tables, "EXLINE_MB_MC");
  trace::Recorder recorder(tables, 256);
  recorder.attach(plant);

  for (const ExampleRow& row : worked_example()) {
    const tables::Time time = row.milliseconds * tables::kMillisecond;
    INFO("at " << row.milliseconds << " ms");
    // There must be no change between the rows.
    if (time > 0) plant.advance_to(time - 1, &recorder);
    for (const auto& [name, on] : row.writes) {
      std::size_t found = tables.symbols.size();
      for (std::size_t i = 0; i < tables.symbols.size(); ++i) {
        if (names[2 * i] == std::string(kExamplePrefix) + std::string(name)) found = i;
      }
      REQUIRE(found != tables.symbols.size());
      plant.set_operation(tables.symbols[found].index, on);
    }
    plant.advance_to(time, &recorder);

    std::string changes;
    recorder.drain([&](const trace::Record& change) {
      if (change.kind != trace::Record::Kind::change) return;
      CHECK(change.time == time);
      std::string_view name = names[std::size_t{2} * change.of];
      name.remove_prefix(kExamplePrefix.size());
      changes.append(changes.empty() ? "" : " ").append(name).append(change.value != 0 ? "=1" : "=0");
      seen(change);
    });
    CHECK(changes == row.changes);
    CHECK(state_text(plant, agv) == row.agv);
    CHECK(state_text(plant, mc) == row.mc);
  }
  CHECK(recorder.lost_changes() == 0);
  CHECK(plant.next_due() == tables::kNever);
}

inline void check_worked_example(plant::Plant& plant) {
  check_worked_example(plant, [](const trace::Record&) {});
}

}  // namespace symplant::test
