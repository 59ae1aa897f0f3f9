// The keys and entries of `times` in plant.json.
#include "description/plant_file.hpp"
#include "elements/times/key.hpp"
#include "support/catch.hpp"

namespace symplant::test {
namespace {

using description::Duration;
using description::times_key_of;
using description::times_key_text;
using description::TimesKey;

/// "FROM|TO|ON", or "none".
std::string parts(std::string_view text) {
  const auto key = times_key_of(text);
  return key ? key->from + "|" + key->to + "|" + key->on : "none";
}

description::PlantFileReading read_times(const std::string& times) {
  return description::read_plant_file(R"({"symplant": 1, "symbols": ["a.csv"], "times": )" + times + "}", "s");
}

std::string times_faults(const std::string& times) {
  std::string text;
  for (const description::DescriptionFault& fault : read_times(times).faults) {
    text += (text.empty() ? "" : "\n") + fault.pointer + ": " + fault.message;
  }
  return text;
}

TEST_CASE("A key of times has two states, and maybe an operation") {
  CHECK(parts("OPEN->CLOSED") == "OPEN|CLOSED|");
  CHECK(parts("OPEN->CLOSED on SHUT") == "OPEN|CLOSED|SHUT");
  CHECK(parts("  OPEN  ->  CLOSED   on  SHUT ") == "OPEN|CLOSED|SHUT");
  CHECK(parts("*->CLOSED") == "*|CLOSED|");
  CHECK(parts("HALF OPEN->ON on TURN ON") == "HALF OPEN|ON|TURN ON");
}

TEST_CASE("Names in a key may be in quotes, in which a quote is doubled") {
  CHECK(parts("'A->B'->'C on D' on 'X'") == "A->B|C on D|X");
  CHECK(parts("'it''s'->B") == "it's|B|");
  CHECK(parts("A->'B'on X") == "none");
}

TEST_CASE("Other texts are no keys of times") {
  for (const std::string_view text : {"", "A", "A->", "->B", "A-B", "A->B on ", "A->B on", "'A->B", "A'->B", "''->B",
                                      "A->B'", "'A'x->B", "A->'B' x", "A->B on 'X' y", " -> "}) {
    INFO(text);
    CHECK(parts(text) == (text == "A->B on" ? "A|B on|" : "none"));
  }
}

TEST_CASE("A written key reads back") {
  for (const TimesKey& key :
       {TimesKey{"A", "B"}, TimesKey{"A", "B", "X"}, TimesKey{"*", "B"}, TimesKey{"A->B", "it's", "X on Y"},
        TimesKey{"A b", "on", "on"}, TimesKey{"'", "->", " on "}}) {
    const std::string text = times_key_text(key);
    INFO(text);
    CHECK(parts(text) == key.from + "|" + key.to + "|" + key.on);
  }
  CHECK(times_key_text({"OPEN", "CLOSED", "SHUT"}) == "OPEN->CLOSED on SHUT");
}

TEST_CASE("An entry of times has fixed, random and computed times, and an overrun") {
  const auto reading = read_times(
      R"({"L_*": {"A->B": {"takes": "0.8s", "after": {"min": "1s", "max": "2s"}}, "A->C on X": {"takes": {"mean": "1s", "sigma": "1ms"}},
          "B->A": {"takes": {"seconds": "2 * LEVEL"}}, "overrun": "never"}, "L_P_D": {"overrun": "3s"}})");
  REQUIRE(reading.sound());
  const std::vector<description::GivenTimes>& times = reading.file->description.times;
  REQUIRE(times.size() == 2);
  CHECK(times[0].device == "L_*");
  CHECK(times[0].overrun == tables::kNever);
  REQUIRE(times[0].transitions.size() == 3);
  CHECK(times[0].transitions[0].key == "A->B");
  CHECK(times[0].transitions[0].takes == Duration::fixed(800 * tables::kMillisecond));
  CHECK(times[0].transitions[0].after == Duration{Duration::Kind::uniform, tables::kSecond, 2 * tables::kSecond});
  CHECK(times[0].transitions[1].of.on == "X");
  CHECK(times[0].transitions[1].takes == Duration{Duration::Kind::normal, tables::kSecond, tables::kMillisecond});
  CHECK_FALSE(times[0].transitions[1].after);
  CHECK(times[0].transitions[2].takes == Duration::seconds("2 * LEVEL"));
  CHECK(times[1].overrun == 3 * tables::kSecond);
  CHECK(times[1].transitions.empty());
}

TEST_CASE("Faults in the form of times") {
  CHECK(times_faults(R"({"D": {"A-B": {}}})") ==
        "/times/D/A-B: `A-B` is not a transition; write `FROM->TO` or `FROM->TO on OPERATION`");
  CHECK(times_faults(R"({"D": {"A->B": {"takes": "1 sec"}}})") ==
        "/times/D/A->B/takes: `1 sec` is not a duration; write a number and ns, us, ms, s, min or h, such as `500ms`");
  CHECK(times_faults(R"({"D": {"A->B": {"take": "1s"}}})") ==
        "/times/D/A->B/take: the key `take` is unknown here; did you mean `takes`?");
  CHECK(times_faults(R"({"D": {"A->B": "1s"}})") ==
        "/times/D/A->B: expected an object with `takes` or `after`, but found the text `1s`");
  CHECK(times_faults(R"({"D": {"overrun": {"min": "1s", "max": "2s"}}})") ==
        "/times/D/overrun: expected a duration such as `2s`, or `never`, but found an object");
  CHECK(times_faults(R"({"D": {"A->B": {"takes": {"min": "2s", "max": "1s"}}}})") ==
        "/times/D/A->B/takes/max: `max` (`1s`) is less than `min`; exchange the two");
  CHECK(times_faults("[]") == "/times: expected an object with the times of each device, but found an array");
}

}  // namespace
}  // namespace symplant::test
