// The key `malfunctions` of plant.json: what is read from it, and what is rejected.
#include <string>

#include "description/faults.hpp"
#include "description/plant_file.hpp"
#include "support/catch.hpp"
#include "support/strings.hpp"

namespace symplant::test {
namespace {

using description::Duration;
using description::GivenMalfunction;
using description::PlantFileReading;
using tables::MalfunctionKind;

PlantFileReading read_malfunctions(const std::string& entries) {
  return description::read_plant_file(R"({"symplant": 1, "symbols": ["a.csv"], "malfunctions": [)" + entries + "]}",
                                      "s");
}

/// All faults: "pointer: message", one per line.
std::string malfunction_faults(const std::string& entries) {
  const PlantFileReading reading = read_malfunctions(entries);
  std::string text;
  for (const json::Placed& fault : reading.syntax) text += "syntax: " + fault.message + "\n";
  for (const description::DescriptionFault& fault : reading.faults) text += fault.pointer + ": " + fault.message + "\n";
  if (!text.empty()) text.pop_back();
  return text;
}

GivenMalfunction sound_malfunction(const std::string& entry) {
  CHECK(malfunction_faults(entry) == "");
  const PlantFileReading reading = read_malfunctions(entry);
  REQUIRE(reading.file);
  REQUIRE(reading.file->description.malfunctions.size() == 1);
  return reading.file->description.malfunctions.front();
}

std::string slower_fault(const std::string& factor) {
  return malfunction_faults(R"({"name": "m", "of": "D", "slower": )" + factor + "}");
}

TEST_CASE("A slower malfunction names devices and a factor") {
  const GivenMalfunction given =
      sound_malfunction(R"({"name": "clamp 1 sluggish", "of": ["S_10_CL*", "S_20_CL1"], "slower": 1.5})");
  CHECK(given.name == "clamp 1 sluggish");
  CHECK(given.one.kinds == std::vector{MalfunctionKind::slower});
  CHECK(given.one.of == std::vector<std::string>{"S_10_CL*", "S_20_CL1"});
  CHECK(given.one.factor == 1500);
  CHECK(sound_malfunction(R"({"name": "m", "of": "D", "slower": 0.001})").one.factor == 1);
  CHECK(sound_malfunction(R"({"name": "m", "of": "D", "slower": 1000})").one.factor == 1'000'000);
  CHECK(sound_malfunction(R"({"name": "m", "of": "D", "slower": 0.333})").one.factor == 333);
}

TEST_CASE("A factor is from 0.001 to 1000 and has at most three decimals") {
  const std::string why = " is not a number from 0.001 to 1000 with at most three decimals";
  for (const std::string factor : {"0.0", "0.0005", "1.2345", "1000.001", "-1", "1e300"}) {
    CHECK(contains(slower_fault(factor), "/malfunctions/0/slower: `"));
    CHECK(contains(slower_fault(factor), why));
  }
  CHECK(contains(slower_fault("\"3\""), "/malfunctions/0/slower: expected a number from 0.001 to 1000"));
}

TEST_CASE("A stuck malfunction is true or a state") {
  CHECK(sound_malfunction(R"({"name": "m", "of": "D", "stuck": true})").one.state == "");
  CHECK(sound_malfunction(R"({"name": "m", "of": "D", "stuck": "OPEN"})").one.state == "OPEN");
  CHECK(contains(malfunction_faults(R"({"name": "m", "of": "D", "stuck": false})"), "/malfunctions/0/stuck: "));
}

TEST_CASE("A force gives symbols values as they are written") {
  const GivenMalfunction given = sound_malfunction(R"({"name": "m", "force": {"A": false, "B": 7, "C": "16#FF"}})");
  REQUIRE(given.one.force.size() == 3);
  CHECK(given.one.force[0].second.bit == false);
  CHECK(given.one.force[1].second.number == "7");
  CHECK(given.one.force[2].second.number == "16#FF");
  CHECK(contains(malfunction_faults(R"({"name": "m", "force": {"A": null}})"), "/malfunctions/0/force/A: "));
}

TEST_CASE("A flicker has a symbol, a time between and a time for which it shows") {
  const GivenMalfunction given = sound_malfunction(
      R"({"name": "m", "flicker": {"symbol": "A", "every": {"min": "1s", "max": "5s"}, "for": "80ms"}})");
  CHECK(given.one.flicker.symbol == "A");
  CHECK(given.one.flicker.every->kind == Duration::Kind::uniform);
  CHECK(given.one.flicker.shows == 80 * tables::kMillisecond);
  CHECK(malfunction_faults(R"({"name": "m", "flicker": {"symbol": "A", "every": "1s"}})") ==
        "/malfunctions/0/flicker: the key `for` is missing here; it holds a duration such as `500ms`");
  CHECK(contains(malfunction_faults(R"({"name": "m", "flicker": {"symbol": "A", "every": "1s", "for": {"min": "1s",
                                       "max": "2s"}}})"),
                 "/malfunctions/0/flicker/for: "));
}

TEST_CASE("A lost link is that of a controller, or of the only one") {
  CHECK(sound_malfunction(R"({"name": "m", "lose": "PLC1"})").one.lose == "PLC1");
  CHECK(sound_malfunction(R"({"name": "m", "lose": true})").one.lose == "");
}

TEST_CASE("A malfunction has exactly one effect") {
  const std::string why =
      "/malfunctions/0: a malfunction needs exactly one of `slower`, `stuck`, `force`, `flicker`, `lose`, `set`, "
      "`distort` "
      "and `effects`";
  CHECK(malfunction_faults(R"({"name": "m"})") == why);
  CHECK(malfunction_faults(R"({"name": "m", "of": "D", "slower": 2, "stuck": true})") == why);
  CHECK(malfunction_faults(R"({"stuck": true, "of": "D"})") ==
        "/malfunctions/0: the key `name` is missing here; it holds a name");
  CHECK(contains(malfunction_faults(R"({"name": "", "lose": true})"), "/malfunctions/0/name: "));
  CHECK(malfunction_faults(R"({"name": "m", "lose": true, "blinks": 1})") ==
        "/malfunctions/0/blinks: the key `blinks` is unknown here");
}

TEST_CASE("A malfunction has several effects, each of one kind, maybe with its own devices") {
  const GivenMalfunction given = sound_malfunction(
      R"({"name": "m", "of": "D", "effects": [{"stuck": true}, {"of": ["E"], "slower": 2}, {"force": {"A": "hold"}},
          {"set": {"wind": 25}}, {"distort": {"symbol": "S", "gain": 1.02, "drift": -0.1}}]})");
  CHECK(given.one.kinds.empty());
  CHECK(given.one.of == std::vector<std::string>{"D"});
  REQUIRE(given.effects.size() == 5);
  CHECK(given.effects[0].kinds == std::vector{MalfunctionKind::stuck});
  CHECK(given.effects[1].of == std::vector<std::string>{"E"});
  CHECK(given.effects[2].force.at(0).second.holds);
  CHECK(given.effects[3].set.at(0) == std::pair<std::string, double>{"wind", 25});
  CHECK(given.effects[4].distort.gain == 1.02);
  CHECK(given.effects[4].distort.offset == 0);
  CHECK(given.effects[4].distort.drift == -0.1);
  CHECK(malfunction_faults(R"({"name": "m", "effects": [{"of": "D"}]})") ==
        "/malfunctions/0/effects/0: an effect needs exactly one of `slower`, `stuck`, `force`, `flicker`, `lose`, "
        "`set` and `distort`");
  CHECK(contains(malfunction_faults(R"({"name": "m", "stuck": true, "effects": [{"lose": true}]})"),
                 "/malfunctions/0: a malfunction needs exactly one of "));
  CHECK(contains(malfunction_faults(R"({"name": "m", "effects": []})"), "/malfunctions/0/effects: "));
  CHECK(malfunction_faults(R"({"name": "m", "distort": {"symbol": "S", "gain": 1}})") ==
        "/malfunctions/0/distort: this malfunction distorts nothing; add `gain`, `offset` or `drift`");
}

TEST_CASE("A malfunction with `while` has no other start or end") {
  const GivenMalfunction given = sound_malfunction(R"({"name": "m", "while": "A", "lose": true})");
  CHECK(given.during);
  CHECK(given.when == "A");
  const auto why = [](const std::string& key) {
    return "/malfunctions/0/" + key +
           ": a malfunction with `while` is active as long as the condition holds; remove `" + key + "`, or `while`";
  };
  CHECK(malfunction_faults(R"({"name": "m", "while": "A", "lose": true, "when": "B"})") == why("when"));
  CHECK(malfunction_faults(R"({"name": "m", "while": "A", "lose": true, "chance": "1s", "lasts": "1s"})") ==
        why("chance") + "\n" + why("lasts"));
  CHECK(malfunction_faults(R"({"name": "m", "while": "A", "lose": true, "becomes": {"after": "1s", "start": "m"}})") ==
        why("becomes"));
}

TEST_CASE("Times of a malfunction are above 0") {
  const std::string why = ": this time is 0; write at least `1ns`";
  CHECK(malfunction_faults(R"({"name": "m", "lose": true, "lasts": "0s"})") == "/malfunctions/0/lasts" + why);
  CHECK(malfunction_faults(R"({"name": "m", "lose": true, "chance": {"min": "0s", "max": "1s"}})") ==
        "/malfunctions/0/chance" + why);
  CHECK(malfunction_faults(R"({"name": "m", "lose": true, "becomes": {"after": "0ms", "start": "m"}})") ==
        "/malfunctions/0/becomes/after" + why);
  CHECK(malfunction_faults(R"({"name": "m", "flicker": {"symbol": "A", "every": "0s", "for": "0s"}})") ==
        "/malfunctions/0/flicker/every" + why + "\n/malfunctions/0/flicker/for" + why);
  const GivenMalfunction given =
      sound_malfunction(R"({"name": "m", "lose": true, "when": "A", "chance": {"mean": "0s", "sigma": "1s"},
                                          "lasts": "1ns", "becomes": {"after": "20s", "unless": "B", "start": "n"}})");
  CHECK(given.when == "A");
  CHECK(given.chance->kind == Duration::Kind::normal);
  CHECK(given.lasts->a == 1);
  CHECK(given.becomes->after == 20 * tables::kSecond);
  CHECK(given.becomes->unless == "B");
  CHECK(given.becomes->start == "n");
}

}  // namespace
}  // namespace symplant::test
