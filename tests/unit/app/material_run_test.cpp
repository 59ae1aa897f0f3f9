// Tests of symplant run with parts: scenarios that put and take them, traces, findings, statistics, maps.
#include <algorithm>

#include "app_support.hpp"
#include "support/temporary_folder.hpp"

namespace symplant::test {
namespace {

constexpr std::string_view kPlantWithParts = R"({
  "symplant": 1, "symbols": ["list.csv"],
  "material": {
    "kinds": { "raw": { "length": "200 mm", "code": 7 }, "done": { "length": "200 mm" } },
    "tracks": { "CV1": { "length": "2 m",
      "drives": [ { "forward": "L_S_CV_O_RUN", "speed": "0.4 m/s" } ],
      "sensors": [ { "symbol": "L_S_PE1_I_PART", "at": "500 mm" },
                   { "symbol": "L_S_NR_I_CODE", "at": "2 m", "reads": "code" } ] } },
    "places": { "FIXTURE": { "sensors": [ { "symbol": "L_S_FIX_I_PART", "inverted": true } ] } },
    "transfers": [ { "name": "pick", "from": "CV1", "to": "FIXTURE", "when": "L_S_RBT_O_PICK", "once": true } ],
    "work": [ { "name": "mill", "at": "FIXTURE", "when": "L_S_MILL_O_ON", "from": "raw", "to": "done" } ],
    "sources": [ { "name": "infeed", "at": "CV1", "kind": "raw", "first": "1s" } ]
  },
  "requirements": [ { "name": "not full", "never": "CV1.parts > 2" } ]
})";

/// The plant, with `steps` as its scenario in a file of `folder`.
struct PartRun {
  explicit PartRun(std::string_view steps, std::vector<std::string> more = {}) {
    files.files["list.csv"] = list_text({{"L_S_CV_O_RUN", "Y1"},
                                         {"L_S_RBT_O_PICK", "Y2"},
                                         {"L_S_MILL_O_ON", "Y3"},
                                         {"L_S_PE1_I_PART", "X1"},
                                         {"L_S_FIX_I_PART", "X2"},
                                         {"L_S_NR_I_CODE", "", "INT", "0"}});
    files.files["plant.json"] = kPlantWithParts;
    folder.write("scenario.json", R"({"symplant-scenario":1,"steps":[)" + std::string(steps) + "]}");
    std::vector<std::string> arguments{"run", "plant.json", "--scenario", folder / "scenario.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    run = run_tool(arguments, files);
  }

  const TemporaryFolder folder;
  MemoryFileSystem files;
  ToolRun run;
};

TEST_CASE("run: Parts that are put, sensed, picked and worked on are in the trace, after the bits of their instant") {
  const PartRun made(
      R"({"at":"1s","set":{"L_S_CV_O_RUN":true}},
         {"at":"10s","set":{"L_S_RBT_O_PICK":true},"expect":"FIXTURE.raw and not CV1.part"},
         {"plus":"1s","set":{"L_S_MILL_O_ON":true},"expect":"FIXTURE.done and FIXTURE.parts = 1"},
         {"plus":"1s","take":"FIXTURE","expect":{"L_S_FIX_I_PART":true}},
         {"plus":"1s","put":{"at":"CV1@1 m","kind":"done"},"expect":"CV1.parts = 1"})",
      {"--trace", "-", "--until", "20s"});
  CHECK(made.run.code == 0);
  CHECK(contains(made.run.out, R"({"t":0,"symbol":"L_S_FIX_I_PART","value":true})"));
  CHECK(contains(made.run.out, R"({"t":1000000000,"symbol":"L_S_CV_O_RUN","value":true}
{"t":1000000000,"part":1,"kind":"raw","to":"CV1","x":200000}
{"t":1750000000,"symbol":"L_S_PE1_I_PART","value":true}
{"t":2250000001,"symbol":"L_S_PE1_I_PART","value":false}
{"t":5500000000,"symbol":"L_S_NR_I_CODE","value":7}
{"t":10000000000,"symbol":"L_S_RBT_O_PICK","value":true}
{"t":10000000000,"symbol":"L_S_FIX_I_PART","value":false}
{"t":10000000000,"symbol":"L_S_NR_I_CODE","value":0}
{"t":10000000000,"part":1,"kind":"raw","from":"CV1","to":"FIXTURE"}
)"));
  CHECK(contains(made.run.out, R"({"t":11000000000,"part":1,"kind":"done"})"));
  CHECK(contains(made.run.out, R"({"t":12000000000,"part":1,"kind":"done","from":"FIXTURE","to":"out","by":"hand"})"));
  CHECK(contains(made.run.out, R"({"t":13000000000,"part":2,"kind":"done","to":"CV1","x":1100000,"by":"hand"})"));
}

TEST_CASE(
    "run: No move of an instantaneous loop is missing in the trace, and all come after the bits of their instant") {
  constexpr int kPairs = 4;  // with three and more the engine passes the moves on before the instant ends
  std::string places = R"("BOX":{"sensors":[{"symbol":"L_S_PE1_I_PART"}]})";
  std::string transfers = R"({"name":"away","from":"BOX","to":"out","when":"L_S_RBT_O_PICK"})";
  std::string puts = R"({"at":"BOX","kind":"raw"})";
  for (const char pair : std::string_view("1234").substr(0, kPairs)) {
    const std::string a = std::string("A") + pair;
    const std::string b = std::string("B") + pair;
    const std::string when = R"(","when":"L_S_RBT_O_PICK"})";
    places += ",\"" + a + "\":{},\"" + b + "\":{}";
    transfers += R"(,{"name":"t)" + a + R"(","from":")" + a + R"(","to":")" + b + when;
    transfers += R"(,{"name":"t)" + b + R"(","from":")" + b + R"(","to":")" + a + when;
    puts += R"(,{"at":")" + a + R"(","kind":"raw"})";
  }
  MemoryFileSystem files;
  files.files["list.csv"] = list_text({{"L_S_RBT_O_PICK", "Y2"}, {"L_S_PE1_I_PART", "X1"}});
  files.files["plant.json"] = R"({"symplant":1,"symbols":["list.csv"],"material":{"kinds":{"raw":{"length":"2 mm"}},
    "places":{)" + places + R"(},"transfers":[)" +
                              transfers + "]}}";
  const TemporaryFolder folder;
  folder.write("scenario.json", R"({"symplant-scenario":1,"steps":[{"at":"0s","put":[)" + puts +
                                    R"(]},{"at":"1s","set":{"L_S_RBT_O_PICK":true}}]})");
  const ToolRun run = run_tool({"run", "plant.json", "--scenario", folder / "scenario.json", "--trace", "-"}, files);
  REQUIRE(run.code == 0);
  std::size_t moves = 0;
  for (std::size_t at = run.out.find(R"("from":)"); at != run.out.npos; at = run.out.find(R"("from":)", at + 1))
    ++moves;
  CHECK(moves == 1 + kPairs * 2 * 200);  // each part there and back in each of 200 rounds
  const std::size_t bit = run.out.find(R"({"t":1000000000,"symbol":"L_S_PE1_I_PART","value":false})");
  CHECK(bit < run.out.find(R"({"t":1000000000,"part":1,"kind":"raw","from":"BOX","to":"out"})"));
  CHECK_FALSE(contains(run.err, "missing in the trace"));
}

TEST_CASE("run: Parts that are put and taken many times at one time are all in the trace") {
  const PartRun made(R"({"repeat":700,"steps":[{"plus":"0s","put":{"at":"FIXTURE","kind":"raw"}},
                                               {"plus":"0s","take":"FIXTURE"}]})",
                     {"--trace", "-"});
  CHECK(made.run.code == 0);
  CHECK(contains(made.run.out, R"({"t":0,"part":700,"kind":"raw","from":"FIXTURE","to":"out","by":"hand"})"));
  CHECK(std::count(made.run.out.begin(), made.run.out.end(), '\n') > 1400);
  CHECK_FALSE(contains(made.run.err, "missing in the trace"));
}

TEST_CASE("run: A part without room, or none to take, fails the step and changes nothing") {
  const PartRun made(R"({"at":"2s","put":[{"at":"FIXTURE","kind":"raw"},{"at":"FIXTURE","kind":"done"}]},
                        {"plus":"1s","take":["CV1","FIXTURE"]},
                        {"plus":"1s","take":"FIXTURE"},
                        {"plus":"0s","expect":"FIXTURE.parts = 0 and CV1.parts = 1"})");
  CHECK(made.run.code == 1);
  CHECK(contains(made.run.err, "no room for a part of kind `done` at FIXTURE at 2 s"));
  CHECK(contains(made.run.err, "FIXTURE has part 2 (raw) since 2 s"));
  CHECK(contains(made.run.err, "no part to take at the end of CV1 at 3 s"));
  CHECK(contains(made.run.err, "no part to take at FIXTURE at 4 s"));
  CHECK(contains(made.run.out, "expectations: 1 held, 3 failed, 0 not reached"));
}

TEST_CASE("run: A robot that puts a part where one lies is a finding that names both parts") {
  const PartRun made(R"({"at":"0s","put":{"at":"FIXTURE","kind":"done"},"set":{"L_S_CV_O_RUN":true}},
                        {"at":"10s","set":{"L_S_RBT_O_PICK":true}},{"at":"11s"})",
                     {"--findings", "-"});
  CHECK(made.run.code == 0);
  CHECK(
      contains(made.run.err,
               "warning: 10 s: part blocked: pick cannot move part 2 (raw) from CV1 to FIXTURE: part 1 is there since "
               "the start"));
  CHECK(contains(made.run.out, R"({"t":10000000000,"finding":"part blocked","of":"pick")"));
}

TEST_CASE("run: A violated requirement about parts is reported, and --stats counts parts by kind") {
  const PartRun made(
      R"({"at":"2s","put":[{"at":"CV1@1 m","kind":"done"},{"at":"CV1@1.5 m","kind":"done"}]},{"at":"3s"})",
      {"--stats", "-"});
  CHECK(made.run.code == 1);
  CHECK(contains(made.run.err, "2 s: requirement violated: `not full`"));
  CHECK(contains(made.run.out,
                 R"("parts":{"raw":{"made":1,"gone":0,"present":1},"done":{"made":2,"gone":0,"present":2}})"));
}

TEST_CASE("run: Slips of `put` and `take` are reported with the nearest name") {
  const PartRun made(R"({"at":"1s","put":{"at":"CV2","kind":"row"}},{"at":"1s","put":{"at":"CV1@3 m","kind":"raw"}},
                        {"at":"1s","take":"FIXTURE@1 m"},{"at":"1s","set":{"L_S_PE1_I_PART":true}})");
  CHECK(made.run.code == 2);
  CHECK(contains(made.run.err, "track or place `CV2` not found; did you mean `CV1`?"));
  CHECK(contains(made.run.err, "kind of part `row` not found; did you mean `raw`?"));
  CHECK(contains(made.run.err, "this is beyond the end of track `CV1`"));
  CHECK(contains(made.run.err, "`FIXTURE` is a place and has no positions"));
  CHECK(contains(made.run.err, "`L_S_PE1_I_PART` is a sensor of parts at `CV1`; put a part there with `put`"));
}

TEST_CASE("run: VCD shows the number of parts on a track and the kinds in a place") {
  const PartRun made(R"({"at":"0s","put":{"at":"FIXTURE","kind":"done"}},{"at":"2s","take":"FIXTURE"},{"at":"3s"})",
                     {"--vcd", "-"});
  CHECK(contains(made.run.out, "$var integer 32"));
  CHECK(contains(made.run.out, "sdone"));
  CHECK(contains(made.run.out, "s- "));
  CHECK(contains(made.run.out, "#1000000000\nb1 "));
}

TEST_CASE("map: What drives the sensors of parts is named") {
  PartRun made(R"({"at":"0s"})");
  const ToolRun map = run_tool({"map", "plant.json"}, made.files);
  CHECK(map.code == 0);
  CHECK(contains(map.out, "parts at CV1"));
  CHECK(contains(map.out, "parts at FIXTURE"));
  CHECK(contains(map.out, "the PLC           L_S_CV, track CV1\n"));
}

}  // namespace
}  // namespace symplant::test
