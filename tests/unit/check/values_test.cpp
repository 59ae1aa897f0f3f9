// Rules about values: circles without damping, numbers without a source, values that nothing reads.
#include "check_support.hpp"
#include "description/plant_file.hpp"

namespace symplant::test {
namespace {

std::vector<Row> tank_rows() {
  std::vector<Row> rows = bits({"S_T_PUMP_O_RUN", "S_T_PUMP_I_RUN", "S_T_VALVE_O_OPEN", "S_T_VALVE_I_OPEN"});
  rows.push_back({"S_T_TANK_I_LEVEL", "", "INT", "0", "%IW40"});
  rows.push_back({"S_T_TANK_O_SET", "", "INT", "0", "%QW40"});
  return rows;
}

Analysed tank(const std::string& members, const std::vector<Row>& rows = tank_rows()) {
  auto reading = description::read_plant_file(R"({"symplant": 1, "symbols": ["a.csv"], )" + members + "}", "s");
  for (const auto& fault : reading.faults) FAIL_CHECK(fault.pointer << ": " << fault.message);
  REQUIRE(reading.file);
  return analyse_described(rows, std::move(reading.file->description));
}

std::string undamped(const std::string& values) {
  return reported(tank("\"values\": {" + values + "}"), "integrals-undamped");
}

/// The values that nothing reads, with the given members of plant.json.
std::string not_read(const std::string& values, const std::string& members = "") {
  const Analysed list = tank("\"values\": {" + values + "}" + (members.empty() ? "" : ", ") + members);
  CHECK(list.evidence().faults.empty());
  std::string names;
  for (const diag::Diagnostic& finding : list.diagnostics.all()) {
    if (finding.rule->slug != "value-not-read") continue;
    for (const diag::Subject& subject : finding.subjects.about) names += (names.empty() ? "" : " ") + subject.name;
  }
  return names;
}

std::string not_driven(const std::vector<Row>& rows, const std::string& members) {
  return reported(tank(members, rows), "number-not-driven");
}

std::vector<Row> with(std::vector<Row> rows, const std::vector<Row>& more) {
  rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

}  // namespace

TEST_CASE("Integrals in a circle without damping are found, with the circle") {
  CHECK(undamped(R"("x": {"integral": "v"}, "v": {"integral": "-4 * x"})") ==
        "/values/x: `x` reads `v` reads `x`: integrals in a circle without damping grow with each step; use `linear`, "
        "or a shorter `step`");
  CHECK(undamped(R"("f": {"is": "-4 * x"}, "x": {"integral": "v"}, "v": {"integral": "f"})") ==
        "/values/x: `x` reads `v` reads `f` reads `x`: integrals in a circle without damping grow with each step; use "
        "`linear`, or a shorter `step`");
  CHECK_FALSE(undamped(R"("a": {"integral": "b"}, "b": {"integral": "c"}, "c": {"integral": "-a"})").empty());
}

TEST_CASE("Two masses on one spring are one finding, two on two springs are two") {
  const std::string one = R"("x": {"integral": "v"}, "v": {"integral": "y - x"},
                             "y": {"integral": "w"}, "w": {"integral": "x - y"})";
  const std::string two = R"("x": {"integral": "v"}, "v": {"integral": "-x"},
                             "y": {"integral": "w"}, "w": {"integral": "-y"})";
  CHECK(undamped(one).find('\n') == std::string::npos);
  CHECK(undamped(one).find("/values/x:") == 0);
  CHECK(undamped(two).find("\n/values/y: ") != std::string::npos);
}

TEST_CASE("A circle with damping, or with another kind of value, is not reported") {
  CHECK(undamped(R"("x": {"integral": "v"}, "v": {"integral": "-4 * x - v"})").empty());
  CHECK(undamped(R"("x": {"integral": "v"}, "v": {"integral": "f"}, "f": {"is": "-4 * x - v"})").empty());
  CHECK(undamped(R"("a": {"integral": "f"}, "b": {"integral": "-f"}, "f": {"is": "b - a"})").empty());
  CHECK(undamped(R"("x": {"integral": "v"}, "v": {"lag": "-4 * x", "time": "1s"})").empty());
  CHECK(undamped(R"("x": {"integral": "v"}, "v": {"ramp": "-4 * x", "up": 1})").empty());
  CHECK(undamped(R"("x": {"integral": "v"}, "v": {"integral": "-4 * d"}, "d": {"delay": "x", "time": "1s"})").empty());
  CHECK(undamped(R"("x": {"integral": "v"}, "v": {"integral": "-4 * x - d"}, "d": {"derivative": "x"})").empty());
}

TEST_CASE("One integral, a chain, and integrals that only jumps join are no circle") {
  CHECK(undamped(R"("x": {"integral": "-x"})").empty());
  CHECK(undamped(R"("x": {"integral": "f"}, "f": {"is": "-x"})").empty());
  CHECK(undamped(R"("a": {"integral": "1"}, "b": {"integral": "a"}, "c": {"integral": "b"})").empty());
  CHECK(undamped(R"("x": {"integral": "v"}, "v": {"integral": "1", "changes": [{"when": "x > 5", "to": "-v"}]})")
            .empty());
}

TEST_CASE("A long circle is shortened in the message") {
  std::string values;
  for (int i = 0; i < 30; ++i) {
    values += (i == 0 ? "" : ", ") + fmt::format(R"("a{}": {{"integral": "-a{}"}})", i, (i + 1) % 30);
  }
  const std::string found = undamped(values);
  CHECK(found.find("`a9` reads `a10`, ... reads `a0`: integrals") != std::string::npos);
  CHECK(found.find("a11") == std::string::npos);
}

TEST_CASE("Circles of the values of one pattern are one finding") {
  const Analysed list = tank(
      R"js("values": {"{self}.x1": {"for": "S_T_*", "integral": "{self}.v1"}, "{self}.v1": {"for": "S_T_*", "integral": "-{self}.x1"}})js",
      bits({"S_T_M1_O_ON", "S_T_M1_I_ON", "S_T_M2_O_ON", "S_T_M2_I_ON", "S_T_M3_O_ON", "S_T_M3_I_ON"}));
  CHECK(list.evidence().faults.empty());
  CHECK(list.count("integrals-undamped") == 1);
}

TEST_CASE("Numeric inputs without a source are one finding that names them") {
  const std::vector<Row> rows = with(tank_rows(), {{"S_T_TANK_I_TEMP", "", "REAL", "0", "%ID50"}});
  CHECK(not_driven(rows, R"("values": {"x": {}})") ==
        ": nothing gives `S_T_TANK_I_LEVEL`, `S_T_TANK_I_TEMP` a number: add them to `signals`");
  CHECK(not_driven(rows, R"("signals": {"S_T_TANK_I_LEVEL": "1"})") ==
        ": nothing gives `S_T_TANK_I_TEMP` a number: add it to `signals`");
  CHECK(not_driven(rows, R"("signals": {"S_T_TANK_I_LEVEL": "1", "S_T_TANK_I_TEMP": "2"})").empty());
}

TEST_CASE("A plant without values and signals may have numbers without a source") {
  CHECK(not_driven(tank_rows(), R"("requirements": [])").empty());
}

TEST_CASE("A number with an initial value, a sensor, custom behavior or another symbol on its address has a source") {
  const std::string values = R"("values": {"x": {}})";
  std::vector<Row> rows = bits({"S_T_PUMP_O_RUN", "S_T_PUMP_I_RUN"});
  CHECK(not_driven(with(rows, {{"S_T_N_I_RECIPE", "", "INT", "5", "%IW40"}}), values).empty());
  CHECK_FALSE(not_driven(with(rows, {{"S_T_N_I_RECIPE", "", "INT", "0", "%IW40"}}), values).empty());
  CHECK(not_driven(with(rows, {{"S_T_N_I_CODE", "", "INT", "0", "%IW40"}}),
                   values +
                       R"(, "material": {"kinds": {"can": {"length": "1 m", "code": 3}},
                "places": {"FIX": {"sensors": [{"symbol": "S_T_N_I_CODE", "reads": "code"}]}}})")
            .empty());
  CHECK(not_driven(with(rows, {{"S_T_PUMP_I_SPEED", "", "INT", "0", "%IW40"}}),
                   values + R"(, "devices": {"S_T_PUMP": {"behaviour": "MyPump"}})")
            .empty());
}

TEST_CASE("Of many numbers without a source ten are named") {
  std::vector<Row> rows = bits({"S_T_PUMP_O_RUN", "S_T_PUMP_I_RUN"});
  for (int i = 10; i < 30; ++i)
    rows.push_back({"S_T_N_I_V" + std::to_string(i), "", "INT", "0", fmt::format("%IW{}", i)});
  const std::string found = not_driven(rows, R"("values": {"x": {}})");
  CHECK(found.find("`S_T_N_I_V19` and 10 more a number: add them to `signals`") != std::string::npos);
  CHECK(found.find("S_T_N_I_V20") == std::string::npos);
}

TEST_CASE("A value that nothing reads is found, also if it reads itself") {
  CHECK(reported(tank(R"("values": {"level": {"integral": "1"}})"), "value-not-read") ==
        "/values/level: nothing reads `level`: remove it, or give it a `trace` if it is only for the trace and the "
        "panel");
  CHECK(
      not_read(R"("a": {"integral": "-a"}, "b": {"is": "a"}, "n": {"changes": [{"when": "n < 5", "to": "n + 1"}]})") ==
      "b n");
}

TEST_CASE("A value with a trace is read, and `false` is no trace") {
  CHECK(not_read(R"("a": {"trace": "1s"}, "b": {"trace": false}, "c": {"integral": "1", "trace": "100ms"})") == "b");
}

TEST_CASE("Formulas, jumps, signals and all conditions read values") {
  CHECK(not_read(R"("a": {}, "b": {"is": "a", "trace": "1s"})").empty());
  CHECK(not_read(R"("a": {}, "b": {"changes": [{"when": "a > 1", "to": "0"}], "trace": "1s"})").empty());
  CHECK(not_read(R"("a": {}, "b": {"changes": [{"when": "b > 1", "to": "a"}], "trace": "1s"})").empty());
  CHECK(not_read(R"("a": {})", R"("signals": {"S_T_TANK_I_LEVEL": "a"})").empty());
  CHECK(not_read(R"("a": {})", R"("requirements": [{"name": "r", "never": "a > 1"}])").empty());
  CHECK(not_read(R"("a": {})",
                 R"("requirements": [{"name": "r", "after": "S_T_PUMP.RUN", "expect": "a > 1", "within": "1s"}])")
            .empty());
  CHECK(not_read(R"("a": {})",
                 R"("devices": {"S_T_PUMP": {"transitions": [{"from": "*", "to": "RUN", "when": "a > 1"}]}})")
            .empty());
  CHECK(not_read(R"("a": {})",
                 R"("devices": {"S_T_PUMP": {"transitions": [{"from": "*", "to": "RUN", "takes": {"seconds": "a"}}]}})")
            .empty());
  CHECK(not_read(R"("a": {}, "b": {})", R"("follow": {"S_T_PUMP_I_RUN": {"on": "a > 1", "off": "b > 1"}})").empty());
  CHECK(not_read(R"("a": {})", R"("malfunctions": [{"name": "m", "of": "S_T_PUMP", "stuck": true, "when": "a > 1"}])")
            .empty());
  const std::string material = R"("material": {"kinds": {"can": {"length": "1 m"}}, "places": {"FIX": {}, "BOX": {}},
      "tracks": {"CV": {"length": "2 m", "drives": [{"speed": {"of": "a", "unit": "1 m/s"}}],
                        "stops": [{"at": "1 m", "when": "b > 1"}], "end": [{"to": "FIX", "when": "c > 1"}]}},
      "transfers": [{"name": "t", "from": "FIX", "to": "BOX", "when": "d > 1"}]})";
  CHECK(not_read(R"("a": {}, "b": {}, "c": {}, "d": {}, "e": {})", material) == "e");
}

TEST_CASE("An output of a value with several counts for it") {
  CHECK(
      not_read(
          R"js("a": {"linear": {"a": [[1]], "b": [[0]], "c": [[1], [2]], "u": ["1"]}}, "b": {"is": "a[2]", "trace": "1s"})js")
          .empty());
}

}  // namespace symplant::test
