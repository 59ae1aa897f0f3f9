// The golden with rows in every table, compiled: it equals the lowered plant.
#include "everything.hpp"

#include "everything/plant_gen.hpp"
#include "everything/types_gen.hpp"
#include "lower/lower.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::test {
namespace {

TEST_CASE("Generated tables have the hash of the lowered ones, for any content") {
  const auto made = everything();
  const lower::EngineTables lowered = lower::lower(made->plant);
  CHECK(tables::model_hash(::everything::tables()) == tables::model_hash(lowered.tables()));
}

TEST_CASE("Every table of the golden has rows") {
  const tables::PlantTables& tables = ::everything::tables();
  for (const std::size_t size : {tables.types.size(),
                                 tables.units.size(),
                                 tables.times.size(),
                                 tables.random_times.size(),
                                 tables.symbols.size(),
                                 tables.initial_values.size(),
                                 tables.shared_addresses.size(),
                                 tables.disables.size(),
                                 tables.conditions.size(),
                                 tables.conditioned_units.size(),
                                 tables.unit_watches.size(),
                                 tables.operation_watches.size(),
                                 tables.event_watches.size(),
                                 tables.operation_value_watches.size(),
                                 tables.event_value_watches.size(),
                                 tables.requirements.size(),
                                 tables.behaviour_units.size(),
                                 tables.behaviour_values.size(),
                                 tables.requirement_names.size(),
                                 tables.behaviour_names.size(),
                                 tables.malfunctions.rows.size(),
                                 tables.malfunctions.units.size(),
                                 tables.malfunctions.forces.size(),
                                 tables.malfunctions.names.size()}) {
    CHECK(size != 0);
  }
}

TEST_CASE("A class states which devices it disables, and which events its states switch") {
  using ::everything::AGV;
  using ::everything::MC;
  const auto disabled = MC::l_disable(1, MC::State::RUN2);
  REQUIRE(disabled.size() == 2);
  CHECK(disabled[0].unit == 0);
  CHECK(disabled[1].unit == 2);
  CHECK(MC::l_disable(1, MC::State::IDLE1).empty());
  CHECK(AGV::l_disable(0, AGV::State::P2).empty());
  CHECK(AGV::l_disable(2, AGV::State::P2).empty());
  static_assert(MC::l_enter(MC::State::RUN2).on == 0b110);
  static_assert(MC::l_leave(MC::State::RUN2).off == 0b110);
  static_assert(MC::d_ext(MC::State::IDLE1, MC::Operation::O_RUN2).lead_to(MC::State::RUN2), "guarded or not");
  static_assert(MC::d_int(MC::State::RUN2).lead_to(MC::State::IDLE1), "guarded or not");
}

TEST_CASE("A generated plant starts and ends the malfunctions of its description, its devices and its inputs by name") {
  using ::everything::Malfunction;
  using ::everything::Symbol;
  ::everything::Plant plant;
  CHECK_FALSE(plant.is_active(Malfunction::int_));
  plant.start(Malfunction::int_);
  plant.advance_to(0);
  CHECK(plant.is_active(Malfunction::int_));
  CHECK(plant.agv().is_in(::everything::AGV::State::P2));
  CHECK(plant.agv().disabled());
  plant.stop(Malfunction::int_);
  plant.advance_to(1);
  CHECK_FALSE(plant.agv().disabled());
  CHECK(plant.agv2().set_stuck());
  CHECK(plant.agv2().set_slow());
  CHECK(plant.set_stuck(Symbol::L_P_MC_I_BUSY3, false));
  plant.advance_to(2);
  CHECK(plant.agv2().disabled());
  CHECK_FALSE(plant.is_on(Symbol::L_P_MC_I_BUSY3));
  CHECK(plant.active_malfunctions().size() == 3);
  plant.free(Symbol::L_P_MC_I_BUSY3);
  CHECK(plant.agv2().set_stuck(false));
  CHECK(plant.agv2().set_slow(false));
  plant.advance_to(3);
  CHECK(plant.is_on(Symbol::L_P_MC_I_BUSY3));
  CHECK(plant.active_malfunctions().empty());
}

}  // namespace
}  // namespace symplant::test
