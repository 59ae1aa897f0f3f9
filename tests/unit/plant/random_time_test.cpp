// Random times: compares draws with numbers computed separately in Python from docs/model.md.
#include <limits>

#include "support/plant_bench.hpp"
#include "symplant/engine/draw.hpp"

namespace symplant::test {
namespace {

using tables::kSecond;
using Kind = description::Duration::Kind;

const std::vector<std::string> kArm = {"ARM_O_A1", "ARM_I_A1", "ARM_O_B2", "ARM_I_B2"};

description::Duration uniform(tables::Time min, tables::Time max) { return {Kind::uniform, min, max}; }
description::Duration normal(tables::Time mean, tables::Time sigma) { return {Kind::normal, mean, sigma}; }

/// The travel times of the arm's next transitions to B2; the return takes its own time.
std::vector<tables::Time> transitions_to_b2(BenchPlant& arm, std::size_t count) {
  std::vector<tables::Time> times;
  tables::Time now = 0;
  arm.to(0);
  for (std::size_t i = 0; i < count; ++i) {
    arm.set("ARM_O_A1", 0).set("ARM_O_B2", 1).to(now);
    times.push_back(arm.unit("ARM").moving ? arm.unit("ARM").remaining : 0);
    now += 10'000;
    arm.to(now).set("ARM_O_B2", 0).set("ARM_O_A1", 1).to(now);
    now += 10'000;
    arm.to(now);
  }
  return times;
}

TEST_CASE("The generator is SplitMix64") {
  std::uint64_t state = 0;
  CHECK(engine::split_mix(state) == 0xE220'A839'7B1D'CDAF);
  CHECK(engine::split_mix(state) == 0x6E78'9E6A'A1B9'65F4);
  CHECK(engine::split_mix(state) == 0x06C4'5D18'8009'454F);
}

TEST_CASE("A uniform travel is drawn again each time that it starts") {
  const BenchTables tables(
      kArm,
      Reported().on_command("ARM", "A1", "B2", uniform(kSecond, 2 * kSecond)).on_command("ARM", "B2", "A1", fixed(1)));
  BenchPlant arm(tables);
  CHECK(transitions_to_b2(arm, 3) == std::vector<tables::Time>{1'109'507'313, 1'559'391'523, 1'353'017'584});
}

TEST_CASE("The seed is that of the reset") {
  const BenchTables tables(
      kArm,
      Reported().on_command("ARM", "A1", "B2", uniform(kSecond, 2 * kSecond)).on_command("ARM", "B2", "A1", fixed(1)));
  BenchPlant arm(tables);
  arm.plant.reset(7);
  CHECK(transitions_to_b2(arm, 3) == std::vector<tables::Time>{1'437'784'872, 1'037'864'581, 1'391'056'880});
}

TEST_CASE("Every transition counts its own draws, by its index in the unit's table") {
  // Two drawn transitions: number 0 is the return, and does not affect the other.
  const BenchTables tables(kArm, Reported()
                                     .on_command("ARM", "B2", "A1", uniform(1, kSecond))
                                     .on_command("ARM", "A1", "B2", uniform(kSecond, 2 * kSecond)));
  BenchPlant arm(tables);
  CHECK(transitions_to_b2(arm, 2) == std::vector<tables::Time>{1'924'800'410, 1'649'502'940});
}

TEST_CASE("A normal travel is the sum of twelve draws") {
  const BenchTables tables(
      kArm,
      Reported().on_command("ARM", "B2", "A1", fixed(1)).on_command("ARM", "A1", "B2", normal(kSecond, kSecond / 5)));
  BenchPlant arm(tables);
  CHECK(transitions_to_b2(arm, 3) == std::vector<tables::Time>{1'136'719'656, 918'231'870, 913'457'333});
  arm.plant.reset(7);
  CHECK(transitions_to_b2(arm, 3) == std::vector<tables::Time>{1'226'961'869, 883'677'981, 818'519'827});
}

TEST_CASE("A normal time is cut at 0, and the arm then arrives at once") {
  const BenchTables tables(
      kArm,
      Reported().on_command("ARM", "B2", "A1", fixed(1)).on_command("ARM", "A1", "B2", normal(kSecond / 10, kSecond)));
  BenchPlant arm(tables);
  CHECK(transitions_to_b2(arm, 8) ==
        std::vector<tables::Time>{783'598'282, 0, 0, 379'336'955, 938'913'196, 0, 0, 1'234'809'346});
}

TEST_CASE("A transition's after and takes share one count, after first") {
  Reported reported;
  reported.by_itself("ARM", "A1", "B2", uniform(kSecond, 2 * kSecond));
  reported.device("ARM").transitions[0].takes = uniform(kSecond, 2 * kSecond);
  reported.on_command("ARM", "B2", "A1", fixed(0));
  const BenchTables tables(kArm, reported);
  BenchPlant arm(tables);
  arm.to(0);
  CHECK(arm.plant.next_due() == 1'109'507'313);  // drawn when its cause became true
  arm.plant.advance_to(1'109'507'313);
  CHECK(arm.unit("ARM").remaining == 1'559'391'523);  // `takes`, drawn when it fired
  arm.to(4000).set("ARM_O_A1", 1).to(5000).set("ARM_O_A1", 0).to(5000);
  CHECK(arm.plant.next_due() == 5 * kSecond + 1'353'017'584);
}

TEST_CASE("An after is drawn again when its cause was interrupted") {
  Reported reported;
  reported.by_itself("ARM", "A1", "B2", uniform(kSecond, 2 * kSecond), "START");
  std::vector<Row> list = bits({"L_P_ARM_O_A1", "L_P_ARM_I_A1", "L_P_ARM_O_B2", "L_P_ARM_I_B2"});
  list.push_back({"START", "", "BOOL", "FALSE", "%IX100"});
  const BenchTables tables(reported, list);
  BenchPlant arm(tables);
  arm.to(0);
  CHECK(arm.plant.next_due() == tables::kNever);
  arm.input("START", 1);
  arm.to(0);
  CHECK(arm.plant.next_due() == 1'109'507'313);
  arm.to(500).input("START", 0);
  arm.to(500).input("START", 1);
  arm.to(500);
  CHECK(arm.plant.next_due() == kSecond / 2 + 1'559'391'523);
}

TEST_CASE("A draw reaches both ends of its range and no further") {
  using tables::RandomTime;
  const RandomTime point{RandomTime::Kind::uniform, 5, 5};
  const RandomTime all{RandomTime::Kind::uniform, 0, std::numeric_limits<tables::Time>::max()};
  const RandomTime two{RandomTime::Kind::uniform, 3, 4};
  std::uint64_t unit = 0xCBF2'9CE4'8422'2325;
  for (const char c : std::string("L_P_ARM")) unit = (unit ^ static_cast<unsigned char>(c)) * 0x0000'0100'0000'01B3;
  CHECK(engine::random_time(point, engine::draw_start(1, unit, 0, 0)) == 5);
  CHECK(engine::random_time(all, engine::draw_start(1, unit, 0, 0)) == 5'159'476'131'126'492'382);
  CHECK(engine::random_time(all, engine::draw_start(1, unit, 0, 1)) == 1'010'026'689'848'020'369);
  int threes = 0;
  for (std::uint64_t start = 0; start < 1000; ++start) {
    const tables::Time drawn = engine::random_time(two, start);
    REQUIRE((drawn == 3 || drawn == 4));
    threes += drawn == 3 ? 1 : 0;
  }
  CHECK(threes > 400);
  CHECK(threes < 600);
}

}  // namespace
}  // namespace symplant::test
