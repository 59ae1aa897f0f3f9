// Tests of the sorting line in virtual time: the PLC's program and the plant are objects of one process, without a
// link.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif

#include "program.hpp"
#include "sorting/plant_gen.hpp"

namespace {

using sorting::Location;
using sorting::PartKind;
using sorting::Plant;
using sorting::Symbol;
using symplant::tables::kMillisecond;
using symplant::tables::kSecond;
using symplant::tables::Time;

/// Runs the program in scans of 20 ms until a time.
void run(Plant& line, sorting::Program& program, Time until) {
  for (Time now = line.now(); now <= until; now += 20 * kMillisecond) {
    line.advance_to(now);
    const sorting::Outputs out = program.scan({.belt_runs = line.is_on(Symbol::SO_M_BELT_I_RUN),
                                               .low = line.is_on(Symbol::SO_M_LOW_I_PART),
                                               .high = line.is_on(Symbol::SO_M_HIGH_I_PART),
                                               .stop1 = line.is_on(Symbol::SO_M_STOP1_I_PART),
                                               .stop2 = line.is_on(Symbol::SO_M_STOP2_I_PART),
                                               .push1_out = line.is_on(Symbol::SO_M_PUSH1_I_OUT),
                                               .push1_back = line.is_on(Symbol::SO_M_PUSH1_I_BACK),
                                               .push2_out = line.is_on(Symbol::SO_M_PUSH2_I_OUT),
                                               .push2_back = line.is_on(Symbol::SO_M_PUSH2_I_BACK)});
    line.set(Symbol::SO_M_BELT_O_RUN, out.belt);
    line.set(Symbol::SO_M_PUSH1_O_OUT, out.push1);
    line.set(Symbol::SO_M_PUSH2_O_OUT, out.push2);
  }
}

}  // namespace

TEST_CASE("In an hour every part slides down a chute and none falls off the belt") {
  Plant line;
  sorting::Program program(0);
  run(line, program, 3600 * kSecond);
  CHECK(line.made(PartKind::low) > 800);
  CHECK(line.made(PartKind::tall) > 500);
  CHECK(line.gone(PartKind::tall) + 5 >= line.made(PartKind::tall));
  CHECK(line.gone(PartKind::low) + 5 >= line.made(PartKind::low));
  CHECK(line.parts(Location::FLOOR) == 0);
}

TEST_CASE("A program that pushes too late loses its parts") {
  Plant line;
  sorting::Program program(30);
  run(line, program, 60 * kSecond);
  CHECK(line.parts(Location::FLOOR) > 0);
}

TEST_CASE("A tall part is seen by both photo-eyes, and may be put and taken by hand") {
  Plant line;
  line.advance_to(0);
  CHECK(line.put(Location::BELT, 1'000'000, PartKind::tall));       // at 1 m
  CHECK_FALSE(line.put(Location::BELT, 1'050'000, PartKind::low));  // a part lies there
  line.advance_to(1 * kSecond);
  CHECK(line.is_on(Symbol::SO_M_LOW_I_PART));
  CHECK(line.is_on(Symbol::SO_M_HIGH_I_PART));
  CHECK(line.parts(Location::BELT, PartKind::tall) == 1);
  CHECK(line.parts(Location::BELT, PartKind::low) == 0);
  CHECK(line.part(Location::BELT, 0).x == 1'100'000);  // its front; its middle is at 1 m
  CHECK_FALSE(line.take(Location::BELT));              // no part is at the end
  CHECK(line.take(Location::BELT, 1'000'000));
  line.advance_to(2 * kSecond);
  CHECK_FALSE(line.is_on(Symbol::SO_M_LOW_I_PART));
  CHECK(line.parts(Location::BELT) == 0);
}
