// The in-process link, with a plant.
#include "symplant/link/loop_link.hpp"

#include "support/catch.hpp"
#include "unit/exec/cell.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;
using tables::kMillisecond;
using tables::kSecond;
using test::SymbolList;

namespace {

/// One cycle, as run_cycles() makes it.
void cycle(plant::Plant& plant, link::Link& link, tables::Time time) {
  link.read_operations(plant, 0);
  plant.advance_to(time);
  link.write_events(plant, {});
  plant.forget_changed_events();
}

}  // namespace

TEST_CASE("A PLC drives the paper's cell by names through the loop") {
  const auto tables = test::cell_tables();
  test::OwnedPlant plant(tables);
  link::LoopLink loop(tables);
  cycle(*plant, loop, 0);
  CHECK(loop.event("EXLINE_MB_AGV_I_P1") == true);
  CHECK(loop.event("exline_mb_agv_i_p2") == false);

  CHECK(loop.set("EXLINE_MB_AGV_O_P2", true));
  cycle(*plant, loop, 500 * kMillisecond);
  CHECK(loop.event("EXLINE_MB_AGV_I_P1") == false);
  CHECK(loop.set("EXLINE_MB_AGV_O_P2", false));
  cycle(*plant, loop, 1499 * kMillisecond);
  CHECK(loop.event("EXLINE_MB_AGV_I_P2") == false);
  cycle(*plant, loop, 1500 * kMillisecond);
  CHECK(loop.event("EXLINE_MB_AGV_I_P2") == true);
}

TEST_CASE("The PLC side reports a symbol of another kind") {
  const auto tables = test::cell_tables();
  link::LoopLink loop(tables);
  CHECK_FALSE(loop.set("EXLINE_MB_AGV_I_P1", true));
  CHECK_FALSE(loop.set("NOBODY", true));
  CHECK_FALSE(loop.set(99U, true));
  CHECK_FALSE(loop.set_value("EXLINE_MB_AGV_O_P2", 1));
  CHECK_FALSE(loop.event("EXLINE_MB_AGV_O_P2").has_value());
  CHECK_FALSE(loop.event_value("EXLINE_MB_AGV_I_P1").has_value());
  CHECK_FALSE(loop.event("NOBODY").has_value());
}

TEST_CASE("Numbers of any width pass through the loop, and a written zero counts") {
  SymbolList list;
  list.add("SPEED", SymbolList::kOut, tables::AddressForm::none, 0, tables::DataType::lreal);
  list.add("LEVEL", SymbolList::kIn, tables::AddressForm::none, 0, tables::DataType::dint);
  list.start_at(0, 5);
  list.start_at(1, 77);
  const auto tables = list.tables();
  test::OwnedPlant plant(tables);
  link::LoopLink loop(tables);
  cycle(*plant, loop, 0);
  CHECK(plant->operation_value(0) == 5);
  CHECK(loop.event_value("LEVEL") == 77U);
  CHECK(loop.set_value("SPEED", 0));
  cycle(*plant, loop, kMillisecond);
  CHECK(plant->operation_value(0) == 0);
  CHECK(loop.set_value("SPEED", 0x4000'0000'0000'0001U));
  cycle(*plant, loop, 2 * kMillisecond);
  CHECK(plant->operation_value(0) == 0x4000'0000'0000'0001U);
}

TEST_CASE("A write acts on all operations of the same address") {
  SymbolList list;
  list.add("A", SymbolList::kOut, 1);
  list.add("B", SymbolList::kOut, 1);
  list.add("C", SymbolList::kOut, 2);
  list.share(1, 0);
  const auto tables = list.tables();
  test::OwnedPlant plant(tables);
  link::LoopLink loop(tables);
  loop.set("B", true);
  cycle(*plant, loop, 0);
  CHECK(plant->operation(0));
  CHECK(plant->operation(1));
  CHECK_FALSE(plant->operation(2));
}
