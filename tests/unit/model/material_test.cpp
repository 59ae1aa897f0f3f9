// The material flow as the model has it: elements, sensors, and conditions about parts.
#include "elements/material/part_words.hpp"
#include "material_support.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::test {
namespace {

TEST_CASE("Kinds, tracks and places have the order of the file") {
  const Analysed list = line_with(R"("kinds": {"z": {"length": "1 mm"}, "a": {"length": "2 mm", "code": 65535}},
    "tracks": {"T9": {"length": "20 mm", "drives": [{"forward": "S_10_CV1.RUN", "speed": "1 mm/s"}]},
               "T1": {"length": "30 mm", "drives": [{"forward": "S_10_CV1.RUN", "speed": "1 mm/s"}]}},
    "places": {"P9": {"holds": 1000}, "P1": {}})");
  CHECK(faults(list) == "");
  const model::Material& material = list.model().material;
  REQUIRE(material.kinds.size() == 2);
  CHECK(material.kinds[0].name == "z");
  CHECK(material.kinds[0].length == 1000);
  CHECK(material.kinds[0].code == 0);
  CHECK(material.kinds[1].code == 65535);
  CHECK(names_text(list) == "T9 T1 | P9 P1 | | |");
  CHECK(material.places[0].holds == 1000);
  CHECK(material.places[1].holds == 1);
  CHECK(material.location_name(3) == "P1");
}

TEST_CASE("The drives of a track cover it in order, each with its conditions and speed") {
  const Analysed list = line_with(kinds() + R"(, "tracks": {"T": {"length": "3 m", "gap": "5 mm", "drives": [
      {"until": "1.5 m", "forward": "S_10_CV1.RUN", "speed": "24 m/min"},
      {"backward": "not S_10_CV1.RUN", "speed": {"of": "s_10_cv1_o_speed", "unit": "0.01 m/s"}}]}})");
  CHECK(faults(list) == "");
  CHECK(drives_text(list) ==
        "T 3000000 gap 5000: ..1500000 S_10_CV1.RUN / - 400000; ..3000000 - / not S_10_CV1.RUN 10000 * "
        "S_10_CV1_O_SPEED;");
}

TEST_CASE("Stops, sensors and ends are resolved") {
  const Analysed list = track_with(R"("stops": [{"at": "3 m", "when": "S_10_STP1.ADV"}],
    "sensors": [{"symbol": "S_10_PE1_I_PART", "at": "0 mm"},
                {"symbol": "S_10_PE2_I_TALL", "at": "2.9 m", "kinds": ["tall", "raw", "TALL"], "inverted": true},
                {"symbol": "S_10_RFID_I_CODE", "at": "3 m", "reads": "code"}],
    "end": [{"to": "P", "when": "S_10_STP1.RET"}, {"to": "T"}, {"to": "OUT"}])",
                                   R"("places": {"P": {"sensors": [{"symbol": "S_10_FIX1_I_PART"}]}})");
  CHECK(faults(list) == "");
  const model::PlantModel& plant = list.model();
  const model::Track& track = plant.material.tracks.at(0);
  REQUIRE(track.stops.size() == 1);
  CHECK(track.stops[0].at == 3'000'000);
  CHECK(model::condition_text(track.stops[0].condition, plant) == "S_10_STP1.ADV");
  CHECK(sensors_text(list, track.sensors) ==
        "S_10_PE1_I_PART@0 reads 0;S_10_PE2_I_TALL@2900000 raw tall reads 0;S_10_RFID_I_CODE@3000000 reads 1;");
  CHECK(sensors_text(list, plant.material.places.at(0).sensors) == "S_10_FIX1_I_PART@0 reads 0;");
  REQUIRE(track.ends.size() == 3);
  CHECK(track.ends[0].to == 1);
  CHECK(text_of(track.ends[0].condition, plant) == "S_10_STP1.RET");
  CHECK(track.ends[1].to == 0);
  CHECK(track.ends[2].to == tables::kOut);
  CHECK_FALSE(track.ends[2].condition);
}

TEST_CASE("The end of a track may be one location") {
  const Analysed list = track_with(R"("end": "out")");
  CHECK(faults(list) == "");
  REQUIRE(list.model().material.tracks.at(0).ends.size() == 1);
  CHECK(list.model().material.tracks[0].ends[0].to == tables::kOut);
}

TEST_CASE("Transfers, work and sources are resolved") {
  const Analysed list = line_of(R"(
    "transfers": [{"name": "pick", "from": "T@2.9 m", "to": "P", "when": "S_10_BTN_I_START", "once": true},
                  {"name": "drop", "from": "P", "to": "t @ 1 m"}, {"name": "scrap", "from": "T", "to": "Out"}],
    "work": [{"name": "mill", "at": "P", "when": "P.part", "from": "raw", "to": "done"}],
    "sources": [{"name": "infeed", "at": "T", "kind": ["raw", "tall", "raw"], "every": {"min": "1s", "max": "2s"},
                 "first": "3s", "when": "T.parts < 3", "count": 100},
                {"name": "one", "at": "T@1 m", "kind": "done"}])");
  CHECK(faults(list) == "");
  const model::PlantModel& plant = list.model();
  const model::Material& material = plant.material;
  CHECK(names_text(list) == "T | P | pick drop scrap | mill | infeed one");
  CHECK(text_of(material.transfers[0].from, plant) == "T@2900000");
  CHECK(text_of(material.transfers[0].to, plant) == "P");
  CHECK(text_of(material.transfers[0].condition, plant) == "S_10_BTN_I_START");
  CHECK(material.transfers[0].once);
  CHECK(text_of(material.transfers[1].to, plant) == "T@1000000");
  CHECK_FALSE(material.transfers[1].condition);
  CHECK_FALSE(material.transfers[1].once);
  CHECK(text_of(material.transfers[2].to, plant) == "out");
  CHECK(material.work[0].from == 0);
  CHECK(material.work[0].to == 1);
  CHECK(model::condition_text(material.work[0].condition, plant) == "P.part");
  const model::Source& infeed = material.sources[0];
  CHECK(infeed.kinds == std::vector<std::uint32_t>{0, 2, 0});
  CHECK(infeed.every == Duration{Duration::Kind::uniform, tables::kSecond, 2 * tables::kSecond});
  CHECK(infeed.first == 3 * tables::kSecond);
  CHECK(infeed.count == 100U);
  CHECK(text_of(infeed.condition, plant) == "T.parts < 3");
  CHECK(text_of(material.sources[1].to, plant) == "T@1000000");
  CHECK_FALSE(material.sources[1].every);
  CHECK_FALSE(material.sources[1].count);
  CHECK(material.sources[1].first == 0);
}

TEST_CASE("The symbol of a sensor is in no device, and its Initial does not count") {
  const Analysed list = track_with(R"("sensors": [{"symbol": "S_10_PE1_I_PART", "at": "1 m"},
                                                  {"symbol": "S_10_STP1_I_PART", "at": "2 m"}])");
  CHECK(faults(list) == "");
  CHECK(find_unit(list.model(), "S_10_PE1") == nullptr);
  CHECK(states_text(unit_of(list, "S_10_STP1")) == "ADV RET");
  CHECK(symbol_of(list, "S_10_PE1_I_PART").account == name::Account::senses_parts);
  CHECK(symbol_of(list, "S_10_PE1_I_PART").unit == model::kNone);
  CHECK(list.count("event-not-driven") == 3);  // BTN, PE2 and FIX1
}

TEST_CASE("A sensor may be inverted in it or by the plant") {
  const std::string sensor = R"("sensors": [{"symbol": "S_10_PE1_I_PART", "at": "1 m", "inverted": )";
  const Analysed in_it = track_with(sensor + "true}]");
  CHECK(faults(in_it) == "");
  CHECK(symbol_of(in_it, "S_10_PE1_I_PART").inverted);
  const std::string track = R"(, "drives": [{"forward": "S_10_CV1.RUN", "speed": "1 m/s"}]}})";
  const auto both = [&](const std::string& value) {
    return line_with(kinds() + R"(, "tracks": {"T": {"length": "3 m", )" + sensor + value + "}]" + track,
                     R"("inverted": ["S_10_PE?_I_*"])");
  };
  const Analysed by_plant = both("false");
  CHECK(faults(by_plant) == "");
  CHECK(symbol_of(by_plant, "S_10_PE1_I_PART").inverted);
  CHECK(faults(both("true")) ==
        "/material/tracks/T/sensors/0/inverted: `S_10_PE1_I_PART` is inverted here and in the plant's `inverted`; "
        "remove one of the two");
}

TEST_CASE("Conditions of devices, inputs, requirements and `follow` may name parts") {
  const Analysed list = line_of("", R"(
    "devices": {"S_10_STP1": {"transitions": [{"from": "RET", "to": "ADV", "when": "T.part", "while": "not P.raw"}],
                              "behaviour": "Stopper", "inputs": {"full": "P.parts >= 1"}},
                "S_*_CV1": {"transitions": [{"from": "*", "to": "RUN", "when": "T.parts < 3 and {self}_O_RUN"}]}},
    "requirements": [{"name": "n", "never": "P.tall"}],
    "follow": {"S_10_BTN_I_START": "T.parts > 2"})");
  CHECK(faults(list) == "");
  CHECK(material_warnings(list) == "");
  const model::PlantModel& plant = list.model();
  const model::Unit& stopper = unit_of(list, "S_10_STP1");
  REQUIRE(stopper.conditions.size() == 3);
  CHECK(model::condition_text(stopper.conditions[0], plant) == "T.part");
  CHECK(model::condition_text(stopper.conditions[1], plant) == "not P.raw");
  CHECK(model::condition_text(stopper.conditions[2], plant) == "P.part");
  REQUIRE(unit_of(list, "S_20_CV1").conditions.size() == 1);
  CHECK(model::condition_text(unit_of(list, "S_20_CV1").conditions[0], plant) == "T.parts < 3 and S_20_CV1_O_RUN");
  REQUIRE(plant.requirements.size() == 1);
  CHECK(model::condition_text(plant.requirements[0].condition, plant) == "P.tall");
  REQUIRE(plant.follows.size() == 1);
  CHECK(model::condition_text(plant.follows[0].condition, plant) == "T.parts > 2");
  CHECK(list.count("condition-decided") == 0);
  CHECK(list.count("condition-decided") == 0);
}

TEST_CASE("Conditions about parts that contradict themselves are found, the parts of a location may change") {
  const auto never_holds = [](const std::string& when) {
    const Analysed list = line_of("", R"("devices": {"S_10_STP1": {"transitions": [{"from": "RET", "to": "ADV",
                                       "when": ")" +
                                          when + "\"}]}}");
    CHECK(faults(list) == "");
    return list.count("condition-decided") == 1;
  };
  CHECK_FALSE(never_holds("T.parts < 3 and T.parts > 5"));  // comparisons of one number are not compared
  CHECK(never_holds("T.raw and not T.raw"));
  CHECK(never_holds("T.parts < 0"));
  CHECK_FALSE(never_holds("T.part and not P.part"));
  CHECK_FALSE(never_holds("T.raw and not T.tall"));
  CHECK_FALSE(never_holds("T.parts > 2 and T.parts < 4"));
}

TEST_CASE("The most parts of a track depend on its length, its gap, and the shortest and longest kind") {
  const auto most = [](const std::string& track) {
    const Analysed list = line_with(kinds() + R"(, "tracks": {"T": {"drives": [{"forward": "S_10_CV1.RUN",
                                    "speed": "1 m/s"}], )" +
                                    track + "}}");
    CHECK(faults(list) == "");
    return model::most_parts(list.model().material, list.model().material.tracks.at(0));
  };
  CHECK(most(R"("length": "3 m")") == 17);  // floor(3.3 / 0.2) + 1
  CHECK(most(R"("length": "3 m", "gap": "100 mm")") == 12);
  CHECK(most(R"("length": "0.3 m")") == 4);
}

TEST_CASE("A device, a condition, a part or the leading symbol on its address drives an input") {
  std::vector<Row> rows = line_rows();
  rows.push_back({"S_10_PE3_I_PART", "", "BOOL", "FALSE", "%IX1"});  // of S_10_CV1_I_RUN
  const Analysed list = line_with(kinds() + R"(, "places": {"P": {"sensors": [{"symbol": "S_10_FIX1_I_PART"}]}})",
                                  R"("follow": {"S_10_BTN_I_START": "S_10_CV1.RUN"})", rows);
  CHECK(faults(list) == "");
  for (const char* name : {"S_10_CV1_I_RUN", "S_10_FIX1_I_PART", "S_10_BTN_I_START", "S_10_PE3_I_PART"}) {
    INFO(name);
    CHECK(model::is_driven(list.model(), symbol_of(list, name)));
  }
  CHECK_FALSE(model::is_driven(list.model(), symbol_of(list, "S_10_PE1_I_PART")));
}

TEST_CASE("A plant without material is the same with an empty object") {
  const auto hash_of = [](const std::string& members) {
    const Analysed list = analyse_described(line_rows(), read_description(members));
    CHECK(faults(list) == "");
    return list.model().units.size();
  };
  CHECK(hash_of(R"("material": {})") == hash_of(R"("name": "n")"));
}

}  // namespace
}  // namespace symplant::test
