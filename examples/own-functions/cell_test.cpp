// A test of the cell as a user writes it: the plant is an object, time is virtual, no PLC and no thread.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif

#include "own_functions/plant_gen.hpp"

using own_functions::AGV;
using own_functions::MC;
using own_functions::Plant;
using own_functions::Symbol;
using symplant::tables::kMillisecond;
using symplant::tables::kSecond;

TEST_CASE("The vehicle drives to the machine, which works only on command") {
  Plant cell;
  cell.advance_to(0);
  cell.agv().command(AGV::Operation::O_P2);
  cell.advance_to(1 * kMillisecond);
  CHECK(cell.agv().moving_to() == AGV::State::P2);

  cell.advance_to(2 * kSecond);
  CHECK(cell.agv().is_in(AGV::State::P2));
  CHECK(cell.mc().is_in(MC::State::IDLE1));

  cell.mc().command(MC::Operation::O_RUN2);
  cell.advance_to(2100 * kMillisecond);
  cell.advance_to(3100 * kMillisecond);
  CHECK(cell.mc().event(MC::Event::I_RUN2));
}

TEST_CASE("A short command does not call the vehicle back, a long one does, slowly") {
  Plant cell;
  auto agv = cell.mb().agv();
  cell.advance_to(0);
  agv.put(AGV::State::P2);

  agv.command(AGV::Operation::O_P1);
  cell.advance_to(100 * kMillisecond);
  agv.command(AGV::Operation::O_P1, false);
  cell.advance_to(250 * kMillisecond);
  CHECK(agv.is_in(AGV::State::P2));

  agv.command(AGV::Operation::O_P1);
  cell.advance_to(300 * kMillisecond);
  cell.advance_to(2000 * kMillisecond);
  CHECK(agv.progress() == 0.5);  // it left at 500 ms
  cell.advance_to(3500 * kMillisecond);
  CHECK(agv.is_in(AGV::State::P1));
}

TEST_CASE("The sensor at P1 stays on until the vehicle is at P2") {
  Plant cell;
  cell.advance_to(0);
  cell.set(Symbol::EXLINE_MB_AGV_O_P2, true);
  cell.advance_to(500 * kMillisecond);
  CHECK(cell.agv().moving_to() == AGV::State::P2);
  CHECK(cell.is_on(Symbol::EXLINE_MB_AGV_I_P1));
  cell.advance_to(2 * kSecond);
  CHECK_FALSE(cell.is_on(Symbol::EXLINE_MB_AGV_I_P1));
  CHECK(cell.is_on(Symbol::EXLINE_MB_AGV_I_P2));
}
