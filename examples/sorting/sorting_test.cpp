// Tests of the sorting line in virtual time: the PLC's program runs in lock step with the plant, without a link.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif

#include "sorting/plant_gen.hpp"
#include "symplant/program/lock_step.hpp"

/// Of program/sorting.c: how many scans a new program waits before it pushes.
extern "C" int sorting_push_delay;

namespace {

using sorting::Location;
using sorting::PartKind;
using sorting::Plant;
using sorting::Symbol;
using symplant::tables::kMillisecond;
using symplant::tables::kSecond;
using symplant::tables::Time;

/// Runs the program in lock step with the line until a time.
void run(Plant& line, int push_delay, Time until) {
  sorting_push_delay = push_delay;
  symplant::program::LockStep programs(line);
  REQUIRE(programs.add(*symplant_program_v1()) == "");
  programs.advance_to(until);
  CHECK_FALSE(programs.failed());
}

}  // namespace

TEST_CASE("In an hour every part slides down a chute and none falls off the belt") {
  Plant line;
  run(line, 0, 3600 * kSecond);
  CHECK(line.made(PartKind::low) > 800);
  CHECK(line.made(PartKind::tall) > 500);
  CHECK(line.gone(PartKind::tall) + 5 >= line.made(PartKind::tall));
  CHECK(line.gone(PartKind::low) + 5 >= line.made(PartKind::low));
  CHECK(line.parts(Location::FLOOR) == 0);
}

TEST_CASE("A program that pushes too late loses its parts") {
  Plant line;
  run(line, 30, 60 * kSecond);
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
