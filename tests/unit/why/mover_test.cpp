// Why transfers, work and sources of parts do nothing.
#include "why_support.hpp"

namespace symplant::test {
namespace {

DescribedPlant cell(const std::string& members) {
  std::vector<Row> rows;
  for (const char* name : {"FWD", "PICK", "FEED"}) {
    rows.push_back({name, "", "BOOL", "FALSE", "%QX" + std::to_string(rows.size())});
  }
  return {rows, R"("material": {"kinds": {"raw": {"length": "200 mm"}, "done": {"length": "200 mm"}},
      "tracks": {"CV": {"length": "2 m", "drives": [{"forward": "FWD", "speed": "0.5 m/s"}]}},
      "places": {"ARM": {}, "NEST": {}}, )" +
                    members + "}"};
}

TEST_CASE("A transfer needs its condition, a part, room, and a new beginning") {
  const DescribedPlant plant =
      cell(R"("transfers": [{"name": "grab", "from": "CV@1 m", "to": "ARM", "when": "PICK", "once": true}])");
  Asked asked(plant);
  asked.put("CV", 500).to(0);
  CHECK(asked.why("grab") ==
        "transfer `grab` moves no part from CV@1000 mm to ARM: `when` needs PICK\n"
        "    PICK has been off since the start, PLC output %QX1, symbol PICK (symbols.csv:3)\n");
  asked.set("PICK").to(1000);
  CHECK(contains(asked.why("grab"),
                 "to ARM: no part is there\n    CV has part 1 (raw) since the start\n"
                 "        part 1 (raw) on CV, with its front at 600 mm, does not move: its drive"));
  asked.put("ARM", -1).set("FWD").to(2000).set("FWD", 0).to(3000);
  CHECK(
      contains(asked.why("grab"), "to ARM: part 2 leaves no room\n    ARM has part 2 (raw) since 1 s: nothing takes"));
  asked.set("PICK", 0).to(4000);
  REQUIRE(asked.plant.take({plant.location("ARM"), tables::kWhole}));
  asked.to(4000).set("PICK").to(5000);
  CHECK(contains(asked.why("grab"),
                 "to ARM: it has moved one, and moves another one after `when` has begun to hold again\n"));
}

TEST_CASE("A part that does not move names the transfers that would take it") {
  const DescribedPlant plant =
      cell(R"("transfers": [{"name": "grab", "from": "CV@1 m", "to": "ARM", "when": "PICK"}])");
  Asked asked(plant);
  asked.put("CV", 1000).to(0);
  CHECK(contains(asked.why("CV"), "    transfer `grab` moves no part from CV@1000 mm to ARM: `when` needs PICK\n"));
}

TEST_CASE("An empty place names what brings parts there, and a full one what takes them") {
  const DescribedPlant plant = cell(R"("transfers": [{"name": "load", "from": "ARM", "to": "NEST", "when": "PICK"}],
      "sources": [{"name": "infeed", "at": "ARM", "kind": "raw", "every": "3s", "first": "9s", "when": "FEED", "count": 2}])");
  Asked asked(plant);
  CHECK(asked.why("NEST") ==
        "NEST has no part\n"
        "    transfer `load` moves no part from ARM to NEST: `when` needs PICK\n"
        "        PICK has been off since the start, PLC output %QX1, symbol PICK (symbols.csv:3)\n");
  CHECK(asked.why("ARM") ==
        "ARM has no part\n"
        "    source `infeed` makes no part at ARM: `when` needs FEED\n"
        "        FEED has been off since the start, PLC output %QX2, symbol FEED (symbols.csv:4)\n");
  asked.set("FEED").to(1000);
  CHECK(asked.why("infeed") == "source `infeed` makes no part at ARM: the next one is due at 9 s\n");
  asked.to(9000).to(12'000);
  CHECK(contains(asked.why("infeed"),
                 "makes no part at ARM: there is no room\n    ARM has part 1 (raw) since 9 s\n"
                 "        transfer `load` moves no part from ARM to NEST: `when` needs PICK\n"));
  asked.set("PICK").to(13'000);
  CHECK(asked.why("infeed") == "source `infeed` makes no part at ARM: it has made all of its parts, 2\n");
}

TEST_CASE("Work waits for the beginning of its condition") {
  const DescribedPlant plant =
      cell(R"("work": [{"name": "mill", "at": "NEST", "when": "PICK", "from": "raw", "to": "done"}])");
  Asked asked(plant);
  CHECK(contains(asked.why("mill"),
                 "work `mill` makes done of raw at NEST when its `when` begins to hold: that needs PICK\n"));
  asked.set("PICK").to(1000);
  CHECK(contains(asked.why("mill"), ": it holds already\n    NEST has no part: nothing brings parts there\n"));
}

}  // namespace
}  // namespace symplant::test
