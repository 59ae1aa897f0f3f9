// The keys `values` and `signals` of plant.json: what is read from them, and what is rejected.
#include <array>
#include <regex>
#include <sstream>
#include <string>

#include "description/plant_file.hpp"
#include "elements/signal/modules.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"

namespace symplant::test {
namespace {

using description::GivenSignal;
using description::GivenValue;
using description::PlantFileReading;
using tables::ValueKind;

PlantFileReading read_members(const std::string& members) {
  return description::read_plant_file(R"({"symplant": 1, "symbols": ["a.csv"], )" + members + "}", "s");
}

/// All faults: "pointer: message", one per line.
std::string faults_of(const std::string& members) {
  const PlantFileReading reading = read_members(members);
  std::string text;
  for (const json::Placed& fault : reading.syntax) text += "syntax: " + fault.message + "\n";
  for (const description::DescriptionFault& fault : reading.faults) text += fault.pointer + ": " + fault.message + "\n";
  if (!text.empty()) text.pop_back();
  return text;
}

std::string value_faults(const std::string& entry) { return faults_of(R"("values": {"v": )" + entry + "}"); }

GivenValue value(const std::string& entry) {
  CHECK(value_faults(entry) == "");
  const PlantFileReading reading = read_members(R"("values": {"v": )" + entry + "}");
  REQUIRE(reading.file);
  return reading.file->description.values.at(0);
}

std::string signal_faults(const std::string& entry) { return faults_of(R"("signals": {"S": )" + entry + "}"); }

GivenSignal signal(const std::string& entry) {
  CHECK(signal_faults(entry) == "");
  const PlantFileReading reading = read_members(R"("signals": {"S": )" + entry + "}");
  REQUIRE(reading.file);
  return reading.file->description.signals.at(0);
}

}  // namespace

TEST_CASE("A value has the kind of its key") {
  CHECK(value("{}").kind == ValueKind::parameter);
  CHECK(value(R"({"integral": "1"})").kind == ValueKind::integral);
  CHECK(value(R"({"lag": "1", "time": "1s"})").time == tables::kSecond);
  const GivenValue ramp = value(R"({"ramp": "x", "up": 2.5, "down": "-5"})");
  CHECK(ramp.formula == "x");
  CHECK(ramp.up == "2.5");
  CHECK(ramp.down == "-5");
  CHECK(value(R"({"delay": "x", "time": "20ms"})").kind == ValueKind::delay);
  CHECK(value(R"({"derivative": "x"})").formula == "x");
  CHECK(value(R"({"position": "AXIS", "at": {"A": 1, "B": 2}})").at.size() == 2);
  CHECK(value(R"({"noise": 0.5, "every": "1s"})").step == tables::kSecond);
  CHECK(value(R"({"pid": {"of": "x", "to": 20, "kp": 2, "ti": "60s"}})").to == "20");
  CHECK(value(R"({"linear": {"a": [[1, 0], [0, 1]], "b": [[1], [0]], "c": [[1, 1]], "u": ["x"]}, "start": [1, 2]})")
            .start_states.size() == 2);
}

TEST_CASE("Values keep the order of the file") {
  const PlantFileReading reading = read_members(R"("values": {"b": {}, "a": {"is": "b"}, "c": {}})");
  REQUIRE(reading.file);
  std::string names;
  for (const GivenValue& each : reading.file->description.values) names += each.name;
  CHECK(names == "bac");
}

TEST_CASE("Numbers of a value are read") {
  const GivenValue read =
      value(R"({"integral": "1", "unit": "l", "start": 2, "min": 1, "max": 3, "step": "1ms", "trace": "1s",
                                    "changes": [{"when": "a", "to": 0}]})");
  CHECK(read.unit == "l");
  CHECK(read.start == 2.0);
  CHECK(read.min == 1.0);
  CHECK(read.max == 3.0);
  CHECK(read.step == tables::kMillisecond);
  CHECK(read.trace == tables::kSecond);
  CHECK(read.changes.at(0).to == "0");
  CHECK(value(R"({"trace": false})").trace == tables::Time{0});
  CHECK(!value(R"({"trace": true})").trace.has_value());
}

TEST_CASE("Two kinds of one value are one fault") {
  CHECK(value_faults(R"({"lag": "x", "ramp": "x", "up": 1})") ==
        "/values/v/ramp: `lag` and `ramp` are two kinds of values; write two values");
}

TEST_CASE("A key that the kind of a value lacks is a fault") {
  CHECK(value_faults(R"({"is": "x", "time": "1s"})") ==
        "/values/v/time: only a value with `lag` and `delay` has `time`; remove it, or add the other key");
  CHECK(value_faults(R"({"is": "x", "start": 1})") == "/values/v/start: a value with `is` has no `start`; remove it");
  CHECK(value_faults(R"({"is": "x", "changes": [{"when": "a", "to": "1"}]})") ==
        "/values/v/changes: a value with `is` follows its formula at each step and cannot jump; remove `changes`");
  CHECK(value_faults(R"({"step": "1ms"})") == "/values/v/step: a parameter has no `step`; remove it");
  CHECK(value_faults(R"({"noise": 1, "step": "1ms"})") ==
        "/values/v/step: the step of `noise` is `every`; write `every`");
  CHECK(value_faults(R"({"start": [1]})") ==
        "/values/v/start: `start` is a number; only `linear` has a list of states");
}

TEST_CASE("A key that the kind of a value needs is a fault") {
  CHECK(value_faults(R"({"lag": "x"})") == "/values/v: `lag` needs `time`");
  CHECK(value_faults(R"({"delay": "x", "time": "0s"})") == "/values/v/time: `time` is above 0");
  CHECK(value_faults(R"({"ramp": "x"})") == "/values/v: `ramp` needs `up`, its rate per second");
  CHECK(value_faults(R"({"position": "A"})") ==
        "/values/v: `position` needs `at`, an object with the number of each state");
}

TEST_CASE("Steps are from 100 us to 1 h") {
  CHECK(value(R"({"is": "x", "step": "100us"})").step == 100 * tables::kMicrosecond);
  CHECK(value_faults(R"({"is": "x", "step": "99us"})") == "/values/v/step: `step` is from 100 us to 1 h");
  CHECK(value_faults(R"({"noise": 1, "every": "61min"})") == "/values/v/every: `every` is from 100 us to 1 h");
  CHECK(faults_of(R"("defaults": {"step": "1us"})") == "/defaults/step: `step` is from 100 us to 1 h");
}

TEST_CASE("A signal is a formula, or has one") {
  CHECK(signal(R"("2 * x")").of == "2 * x");
  CHECK(signal("5").of == "5");
  const GivenSignal read =
      signal(R"({"of": "x", "from": [0, 100], "to": [0, 27648], "limit": [-1, 2], "noise": 5, "every": "1s"})");
  CHECK((*read.to)[1] == 27648);
  CHECK((*read.limit)[0] == -1);
  CHECK(read.noise == 5);
  CHECK(read.every == tables::kSecond);
}

TEST_CASE("The analog modules are those of docs/values.md, with its numbers") {
  std::istringstream page(read_bytes(std::string(SYMPLANT_SOURCE_DIR) + "/docs/values.md"));
  std::string names;
  for (std::string line; std::getline(page, line);) {
    static const std::regex kRow("\\| `([a-z0-9-]+)` \\| (-?[0-9]+) to (-?[0-9]+) \\| (-?[0-9]+) to (-?[0-9]+) \\| .*");
    std::smatch row;
    if (!std::regex_match(line, row, kRow)) continue;
    INFO(line);
    names += (names.empty() ? "`" : ", `") + row[1].str() + "`";
    const description::AnalogModule* module = description::analog_module(row[1].str());
    REQUIRE(module != nullptr);
    CHECK(module->to == std::array{std::stod(row[2]), std::stod(row[3])});
    CHECK(module->limit == std::array{std::stod(row[4]), std::stod(row[5])});
  }
  CHECK(names == description::analog_module_names());
}

TEST_CASE("An analog module gives the range and the limits of a signal") {
  const GivenSignal read = signal(R"({"of": "x", "from": [0, 10], "as": "s7-unipolar"})");
  CHECK((*read.to)[1] == 27648);
  CHECK((*read.limit)[0] == -4864);
  CHECK(signal_faults(R"({"of": "x", "from": [0, 10], "as": "s8"})") ==
        "/signals/S/as: unknown analog module `s8`; choose one of " + description::analog_module_names());
  CHECK(signal_faults(R"({"of": "x", "from": [0, 10], "to": [0, 1], "as": "s7-unipolar"})") ==
        "/signals/S/to: `as` gives `to`; remove one of them");
}

TEST_CASE("The scale of a signal has two ends") {
  CHECK(signal_faults(R"({"of": "x", "from": [0, 10]})") ==
        "/signals/S/from: `from` needs `to`, the numbers at its ends");
  CHECK(signal_faults(R"({"of": "x", "to": [0, 10]})") ==
        "/signals/S: `to` and `as` need `from`, the numbers of the formula at both ends");
  CHECK(signal_faults(R"({"of": "x", "from": [1, 1], "to": [0, 10]})") ==
        "/signals/S/from: both ends of `from` are equal; write two different numbers");
  CHECK(signal_faults(R"({"of": "x", "limit": [2, 1]})") ==
        "/signals/S/limit: the first number of `limit` is above the second one; exchange them");
  CHECK(signal_faults(R"({"of": "x", "every": "1us"})") == "/signals/S/every: `every` is at least 100 us");
}

}  // namespace symplant::test
