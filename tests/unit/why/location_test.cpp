// Why parts on tracks do not move, and what sensors see.
#include "why_support.hpp"

namespace symplant::test {
namespace {

/// A track of 2 m with more members, driven by symbols.
DescribedPlant track(const std::string& members, const std::string& more = "",
                     const std::string& drives = R"([{"forward": "FWD", "speed": "0.5 m/s"}])") {
  std::vector<Row> rows;
  for (const char* name : {"FWD", "BWD", "FWD2", "GATE"}) {
    rows.push_back({name, "", "BOOL", "FALSE", "%QX" + std::to_string(rows.size())});
  }
  rows.push_back({"SPEED", "", "INT", "0", "%QW9"});
  rows.push_back({"SLOW", "", "REAL", "0.7", "%QD40"});
  rows.push_back({"EYE", "", "BOOL", "FALSE", "%IX0"});
  rows.push_back({"NEST", "", "BOOL", "FALSE", "%IX1"});
  return {rows, R"("material": {"kinds": {"raw": {"length": "200 mm"}, "tall": {"length": "200 mm"}},
      "tracks": {"CV": {"length": "2 m", "gap": "10 mm", "drives": )" +
                    drives + members + "}}" + more + "}"};
}

TEST_CASE("A part moves, or its drive is off") {
  const DescribedPlant plant = track("");
  Asked asked(plant);
  asked.put("CV", 500).to(0);
  CHECK(asked.why("CV") ==
        "CV has part 1 (raw) since the start\n"
        "    part 1 (raw) on CV, with its front at 600 mm, does not move: its drive is off, `forward` needs FWD\n"
        "        FWD has been off since the start, PLC output %QX0, symbol FWD (symbols.csv:2)\n");
  asked.set("FWD").to(1000);
  CHECK(contains(asked.why("CV"), "    part 1 (raw) on CV, with its front at 600 mm, moves at 500 mm/s\n"));
  CHECK(asked.why("CV", false) ==
        "CV has part 1 (raw) since the start\n    part 1 (raw) has been on CV since the start\n");
}

TEST_CASE("A stop, a hard end and the part ahead hold parts") {
  const DescribedPlant plant = track(R"(, "stops": [{"at": "1 m", "when": "not GATE"}])");
  Asked asked(plant);
  asked.put("CV", 700).put("CV", 400).set("FWD").to(0).to(5000);
  CHECK(asked.why("CV") ==
        "CV has part 1 (raw) since the start, part 2 (raw) since the start\n"
        "    part 1 (raw) on CV, with its front at 1000 mm, does not move: the stop at 1000 mm holds\n"
        "        GATE has been off since the start, PLC output %QX3, symbol GATE (symbols.csv:5)\n"
        "    part 2 (raw) on CV, with its front at 790 mm, does not move: part 1 is in front of it\n"
        "        part 1 (raw) on CV, with its front at 1000 mm, does not move, see above\n");
  asked.set("GATE").to(6000).to(10'000);
  CHECK(contains(asked.why("CV"), "with its front at 2000 mm, does not move: the track ends there\n"));
}

TEST_CASE("An end that is closed, and one without room, are named") {
  const DescribedPlant plant = track(R"(, "end": [{"to": "A", "when": "GATE"}, {"to": "B", "when": "BWD"}])",
                                     R"(, "places": {"A": {}, "B": {}})");
  Asked asked(plant);
  asked.put("CV", 1800).set("FWD").to(0).to(5000);
  CHECK(contains(asked.why("CV"),
                 "does not move: the track ends there, to A `when` needs GATE, to B `when` needs BWD\n"
                 "        GATE has been off"));
  asked.put("A", -1).set("GATE").to(6000);
  CHECK(contains(asked.why("CV"),
                 "does not move: the track ends there, A has no room\n"
                 "        A has part 2 (raw) since 5 s: nothing takes parts from there\n"));
}

TEST_CASE("A stop at the end of a track holds what would leave") {
  const DescribedPlant plant = track(R"(, "stops": [{"at": "2 m", "when": "not GATE"}], "end": "out")");
  Asked asked(plant);
  asked.put("CV", 1800).set("FWD").to(0).to(5000);
  CHECK(contains(asked.why("CV"), "with its front at 2000 mm, does not move: the stop at 2000 mm holds\n        GATE"));
}

TEST_CASE("Drives that face each other, are commanded in both directions, or have no speed") {
  const DescribedPlant facing = track("", "", R"([{"until": "1 m", "forward": "FWD", "speed": "0.5 m/s"},
                                                  {"backward": "BWD", "speed": "0.5 m/s"}])");
  Asked between(facing);
  between.put("CV", 700).set("FWD").set("BWD").to(0).to(5000);
  CHECK(
      contains(between.why("CV"), "with its front at 1100 mm, does not move: two drives push it against each other\n"));
  const DescribedPlant both =
      track("", "", R"([{"forward": "FWD", "backward": "BWD", "speed": {"of": "SPEED", "unit": "1 mm/s"}}])");
  Asked asked(both);
  asked.put("CV", 700).set("FWD").to(1000);
  CHECK(contains(asked.why("CV"),
                 "does not move: the speed of its drive is 0\n        SPEED has been 0 since the start"));
  asked.set("BWD").to(2000);
  CHECK(
      contains(asked.why("CV"), "does not move: its drive is commanded forward and backward\n        FWD has been on"));
  asked.set("FWD", 0).set("SPEED", 100).to(3000);
  CHECK(contains(asked.why("CV"), "moves backward at 100 mm/s"));
  asked.to(13'000);
  CHECK(contains(asked.why("CV"), "with its front at 200 mm, does not move: it is at the start of the track\n"));
  asked.set("BWD", 0).to(14'000);
  CHECK(contains(asked.why("CV"), "does not move: its drive is off, `forward` needs FWD, `backward` needs BWD\n"));
}

TEST_CASE("A speed below one micrometer per second is 0") {
  const DescribedPlant plant = track("", "", R"([{"forward": "not FWD", "speed": {"of": "SLOW", "unit": "1 um/s"}}])");
  Asked asked(plant);
  asked.put("CV", 700).to(1000);
  CHECK(contains(asked.why("CV"), "does not move: the speed of its drive is 0\n        SLOW has been 0.7 since"));
}

TEST_CASE("A sensor names the part that it sees, or the nearest one and why that does not come") {
  const DescribedPlant plant = track(R"(, "sensors": [{"symbol": "EYE", "at": "1 m", "kinds": ["tall"]}])",
                                     R"(, "places": {"BOX": {"sensors": [{"symbol": "NEST"}]}})");
  Asked asked(plant);
  CHECK(asked.why("EYE") ==
        "EYE has been off since the start, PLC input %IX0, symbol EYE (symbols.csv:8): it sees parts of kind tall at "
        "CV@1000 mm\n"
        "    CV has no part: nothing brings parts there\n");
  asked.put("CV", 500, 1).put("CV", 1500).to(0);
  CHECK(contains(asked.why("EYE"),
                 "at CV@1000 mm, and part 1 comes next\n"
                 "    part 1 (tall) on CV, with its front at 600 mm, does not move: its drive is off"));
  REQUIRE(asked.plant.take({plant.location("CV"), 500'000}));
  asked.to(0);
  CHECK(contains(asked.why("EYE"), "at CV@1000 mm, and part 2 has passed it\n"));
  asked.put("CV", 500, 1).set("FWD").to(500).to(1400).set("FWD", 0).to(1500);
  CHECK(contains(asked.why("EYE"), "EYE has been on since 1.3 s"));
  CHECK(contains(asked.why("EYE"), "and part 3 covers it\n    part 3 (tall) on CV"));
  CHECK(contains(asked.why("NEST"), ": it sees parts at BOX\n    BOX has no part: nothing brings parts there\n"));
}

}  // namespace
}  // namespace symplant::test
