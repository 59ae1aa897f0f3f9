// Entries of the material flow for a pattern of devices.
#include "material_support.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::test {
namespace {

Analysed conveyors(const std::string& members, const std::string& further = "") {
  return line_with(kinds() + R"(, "tracks": {"{line}_{process}_T{1}": {"for": "S_?0_CV1", "length": "3 m", )" +
                   members + "}}" + (further.empty() ? "" : ", ") + further);
}

const std::string kDrive = R"("drives": [{"forward": "{self}.RUN", "speed": "0.5 m/s"}])";

TEST_CASE("An entry with `for` is made once for each matched device, with its names") {
  const Analysed list = conveyors(
      R"("sensors": [{"symbol": "{line}_{process}_STP1_I_PART", "at": "1 m"}],
         "stops": [{"at": "1 m", "when": "{line}_{process}_STP1.ADV"}], "end": "{line}_{process}_P", )" +
          kDrive,
      R"("places": {"{line}_{process}_P": {"for": "S_*_CV1"}},
         "transfers": [{"name": "{self} out", "for": "S_*_CV1", "from": "S_{1}_P", "to": "out", "when": "{self}.RUN"}],
         "work": [{"name": "w{1}", "for": "S_*_CV1", "at": "S_{1}_P", "when": "{device}_{1} or true_{1}",
                   "from": "raw", "to": "done"}],
         "sources": [{"name": "s{1}", "for": "S_*_CV1", "at": "S_10_T1@1 m", "kind": ["raw", "tall"]}])");
  CHECK(faults(list) == (description::Pointer("/material") / "work" / 0).text() +
                            ": symbol `CV1_10` not found (the other match lacks it too)");
  CHECK(names_text(list) == "S_10_T1 S_20_T2 | S_10_P S_20_P | S_10_CV1 out S_20_CV1 out | | s10 s20");
}

TEST_CASE("What entries with `for` make is what they would be written out") {
  const Analysed made = conveyors(
      R"("sensors": [{"symbol": "{line}_{process}_STP1_I_PART", "at": "1 m"}],
         "stops": [{"at": "1 m", "when": "{line}_{process}_STP1.ADV"}], "end": "S_10_T1", )" +
      kDrive);
  CHECK(faults(made) == "");
  CHECK(material_warnings(made) == "");
  CHECK(names_text(made) == "S_10_T1 S_20_T2 | | | |");
  CHECK(drives_text(made, 1) == "S_20_T2 3000000 gap 0: ..3000000 S_20_CV1.RUN / - 500000;");
  const model::Track& track = made.model().material.tracks.at(1);
  CHECK(sensors_text(made, track.sensors) == "S_20_STP1_I_PART@1000000 reads 0;");
  CHECK(model::condition_text(track.stops.at(0).condition, made.model()) == "S_20_STP1.ADV");
  CHECK(track.ends.at(0).to == 0);
  CHECK(track.given == 0);
}

TEST_CASE("A plant described by `for` is the plant written out") {
  const auto hash = [](const std::string& material) {
    const CompiledText compiled =
        compile_described(line_rows(), read_description("\"material\": {" + kinds() + ", " + material + "}"));
    REQUIRE(compiled.compiled);
    return tables::model_hash(compiled.compiled->tables.tables());
  };
  const std::string members = R"(: {"length": "1 m", "drives": [{"forward": ")";
  const std::string made = R"("tracks": {"T{1}")" + members + R"({self}.RUN", "speed": "1 m/s"}], "for": "S_*_CV1",
    "sensors": [{"symbol": "{line}_{process}_STP1_I_PART", "at": "1 m", "inverted": true}]}},
    "sources": [{"name": "{self}", "for": "S_*_CV1", "at": "T{1}", "kind": "raw"}])";
  const std::string written = R"("tracks": {"T10")" + members + R"(S_10_CV1.RUN", "speed": "1 m/s"}],
      "sensors": [{"symbol": "S_10_STP1_I_PART", "at": "1 m", "inverted": true}]},
    "T20")" + members + R"(S_20_CV1.RUN", "speed": "1 m/s"}],
      "sensors": [{"symbol": "S_20_STP1_I_PART", "at": "1 m", "inverted": true}]}},
    "sources": [{"name": "S_10_CV1", "at": "T10", "kind": "raw"}, {"name": "S_20_CV1", "at": "T20", "kind": "raw"}])";
  CHECK(hash(made) == hash(written));
  CHECK(hash(made) != hash(R"("places": {"P": {}})"));
}

TEST_CASE("An entry is left out for devices for which the plant lacks what it names") {
  const Analysed list = conveyors(kDrive, R"("places": {"{self}_F": {"for": "S_*_CV1",
      "sensors": [{"symbol": "{line}_{process}_STP1_I_PART"}, {"symbol": "{line}_{process}_FIX1_I_PART"}]}},
      "transfers": [{"name": "{self}", "for": "S_*_CV1", "from": "S_{1}_CV1_F", "to": "out"}])");
  CHECK(faults(list) == "");
  CHECK(names_text(list) == "S_10_T1 S_20_T2 | S_10_CV1_F | S_10_CV1 | |");
  const std::string rest = "; the entry is left out for `S_20_CV1`, 1 of the 2 matches";
  CHECK(material_warnings(list) == "/material/places/{self}_F: symbol `S_20_FIX1_I_PART` not found" + rest +
                                       "\n/material/transfers/0: track or place `S_20_CV1_F` not found" + rest);
  CHECK(symbol_of(list, "S_10_STP1_I_PART").unit == model::kNone);
  CHECK(states_text(unit_of(list, "S_20_STP1")) == "ADV RET PART");
}

TEST_CASE("Conditions and kinds may be lacking, too") {
  const Analysed list = conveyors(kDrive, R"("transfers": [
          {"name": "{self}", "for": "S_*_CV1", "from": "S_20_T2", "to": "out", "when": "{line}_{process}_PE1.PART"}],
        "sources": [{"name": "{self}", "for": "S_*_CV1", "at": "S_20_T2", "kind": "k{1}"}])");
  CHECK(faults(list) == "/material/sources/0: kind of part `k10` not found (the other match lacks it too)");
  CHECK(material_warnings(list) ==
        "/material/transfers/0: device `S_20_PE1` not found; the entry is left out for "
        "`S_20_CV1`, 1 of the 2 matches");
}

TEST_CASE("What the plant lacks for every match of an entry is one error") {
  CHECK(faults(conveyors(R"("end": "{self}_X", )" + kDrive)) ==
        "/material/tracks/{line}_{process}_T{1}: track or place `S_10_CV1_X` not found (the other match lacks it too)");
}

TEST_CASE("A fault of an entry with `for` is reported once") {
  const std::string others = " (also for others that `S_?0_CV1` matches)";
  const std::string here = "/material/tracks/{line}_{process}_T{1}/";
  CHECK(faults(conveyors(R"("stops": [{"at": "4 m", "when": "{self}.RUN"}], )" + kDrive)) ==
        here + "stops/0/at: this position is beyond the end of track `S_10_T1`" + others);
  CHECK(faults(conveyors(R"("stops": [{"at": "1 m", "when": "{slef}.RUN"}], )" + kDrive)) ==
        here + "stops/0/when: `{slef}` is unknown here; use one of `{line}`, `{process}`, `{device}`, `{self}`, `{1}`" +
            others);
  CHECK(faults(conveyors(R"("stops": [{"at": "1 m", "when": "{self}.RUN and"}], )" + kDrive)).ends_with(others));
  const std::string places = R"("places": {"P": {"for": "S_*_CV1"}}, )";
  CHECK(faults(line_with(places + kinds())) ==
        "/material/places/P: `P` already names another track or place; use `{self}` in the name");
  CHECK(faults(line_with(R"("places": {"P": {}}, "transfers": [{"name": "n", "for": "S_*_CV1", "from": "P",
                         "to": "out"}], )" +
                         kinds())) ==
        "/material/transfers/0/name: `n` already names another entry of this list; use `{self}` in the name");
}

TEST_CASE("One symbol cannot be the sensor of several matches") {
  CHECK(faults(conveyors(R"("sensors": [{"symbol": "S_10_PE1_I_PART", "at": "1 m"}], )" + kDrive)) ==
        "/material/tracks/{line}_{process}_T{1}/sensors/0/symbol: `S_10_PE1_I_PART` belongs to another sensor too; "
        "remove one of the two");
}

TEST_CASE("A device of which a sensor is the only symbol is matched, too") {
  const Analysed list =
      line_with(kinds() + R"(, "places": {"{self}": {"for": "S_10_FIX?", "sensors": [{"symbol": "{self}_I_PART"}]}})");
  CHECK(faults(list) == "");
  CHECK(names_text(list) == "| S_10_FIX1 | | |");
  CHECK(find_unit(list.model(), "S_10_FIX1") == nullptr);
}

TEST_CASE("A pattern of the material flow that matches no device is a warning") {
  const Analysed list = line_with(kinds() + R"(, "places": {"{self}": {"for": "X*"}})");
  CHECK(faults(list) == "");
  CHECK(material_warnings(list) == "/material/places/{self}/for: `X*` matches no device");
}

TEST_CASE("Without `for` an entry of the material flow has no names in braces") {
  const std::string rest = " is replaced by a name only with `for`; add `for`, or write the name";
  CHECK(faults(line_of(R"("transfers": [{"name": "{self}", "from": "P", "to": "out"}])")) ==
        "/material/transfers/0/name: `{self}`" + rest);
  CHECK(faults(line_with(kinds() + R"(, "places": {"{1}": {}})")) == "/material/places/{1}: `{1}`" + rest);
  CHECK(faults(track_with(R"("stops": [{"at": "1 m", "when": "{self}.RUN"}])")) ==
        "/material/tracks/T/stops/0/when: `{self}`" + rest);
}

TEST_CASE("A fault of braces has no consequences") {
  const std::string rest = " is replaced by a name only with `for`; add `for`, or write the name";
  const std::string further = R"("transfers": [{"name": "n", "from": "T", "to": "out", "when": "T.part"}])";
  CHECK(faults(track_with(R"("end": "{self}")", further)) == "/material/tracks/T/end/0/to: `{self}`" + rest);
  CHECK(faults(conveyors(R"("end": "{slf}", )" + kDrive,
                         R"("transfers": [{"name": "n", "from": "S_10_T1", "to": "S_20_T2"}])"))
            .ends_with("(also for others that `S_?0_CV1` matches)"));
}

TEST_CASE("Conditions of patterns may name the tracks that `for` makes") {
  const Analysed list =
      line_with(kinds() + R"(, "tracks": {"S_{process}_T": {"for": "S_*_CV1", "length": "3 m", )" + kDrive + "}}",
                R"("devices": {"S_*_STP1": {"transitions": [
                                      {"from": "RET", "to": "ADV", "when": "{line}_{process}_T.part"}]}})");
  CHECK(faults(list) == "");
  CHECK(material_warnings(list) == "");
  CHECK(model::condition_text(unit_of(list, "S_20_STP1").conditions.at(0), list.model()) == "S_20_T.part");
}

}  // namespace
}  // namespace symplant::test
