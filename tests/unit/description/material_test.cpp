// The key `material` of plant.json: what is read from it, and what is rejected.
#include <string>

#include "description/faults.hpp"
#include "description/plant_file.hpp"
#include "support/catch.hpp"

namespace symplant::test {
namespace {

using description::Duration;
using description::GivenMaterial;
using description::PlantFileReading;

PlantFileReading read_material(const std::string& members) {
  return description::read_plant_file(R"({"symplant": 1, "symbols": ["a.csv"], "material": {)" + members + "}}", "s");
}

/// All faults: "pointer: message", one per line.
std::string material_faults(const std::string& members) {
  const PlantFileReading reading = read_material(members);
  std::string text;
  for (const json::Placed& fault : reading.syntax) text += "syntax: " + fault.message + "\n";
  for (const description::DescriptionFault& fault : reading.faults) text += fault.pointer + ": " + fault.message + "\n";
  if (!text.empty()) text.pop_back();
  return text;
}

GivenMaterial sound_material(const std::string& members) {
  CHECK(material_faults(members) == "");
  const PlantFileReading reading = read_material(members);
  REQUIRE(reading.file);
  return reading.file->description.material;
}

/// The length of a kind.
std::int64_t um(const std::string& length) {
  return sound_material(R"("kinds": {"k": {"length": ")" + length + "\"}}").kinds.at(0).length;
}

std::string length_fault(const std::string& length) {
  const std::string where = "/material/kinds/k/length: ";
  std::string fault = material_faults(R"("kinds": {"k": {"length": )" + length + "}}");
  REQUIRE(fault.starts_with(where));
  return fault.substr(where.size());
}

std::string track(const std::string& members) { return R"("tracks": {"T": {"length": "3 m", )" + members + "}}"; }

std::string drive(const std::string& speed) { return track(R"("drives": [{"forward": "A", "speed": )" + speed + "}]"); }

std::int64_t um_per_s(const std::string& speed) {
  return sound_material(drive("\"" + speed + "\"")).tracks.at(0).drives.at(0).speed.speed;
}

std::string speed_fault(const std::string& speed) {
  const std::string where = "/material/tracks/T/drives/0/speed";
  std::string fault = material_faults(drive(speed));
  REQUIRE(fault.starts_with(where));
  return fault.substr(where.size());
}

TEST_CASE("A length is a whole number of micrometers") {
  CHECK(um("300 mm") == 300'000);
  CHECK(um("300mm") == 300'000);
  CHECK(um("1.5 m") == 1'500'000);
  CHECK(um("2.5cm") == 25'000);
  CHECK(um("1 um") == 1);
  CHECK(um("0.001 mm") == 1);
  CHECK(um("1000 m") == 1'000'000'000);
}

TEST_CASE("An invalid, a too fine and a too long length have different messages") {
  const std::string none = "` is not a length; write a number and um, mm, cm or m, such as `300 mm`";
  CHECK(length_fault("\"300\"") == "`300" + none);
  CHECK(length_fault("\"3 km\"") == "`3 km" + none);
  CHECK(length_fault("\"-3 m\"") == "`-3 m" + none);
  CHECK(length_fault("\"3 M\"") == "`3 M" + none);
  CHECK(length_fault("\".5 m\"") == "`.5 m" + none);
  CHECK(length_fault("\"1. m\"") == "`1. m" + none);
  CHECK(length_fault("\"0.0001 mm\"") == "`0.0001 mm` has a part below 1 um; give it fewer decimals");
  CHECK(length_fault("\"0.5um\"") == "`0.5um` has a part below 1 um; give it fewer decimals");
  const std::string large = " is longer than the maximum of 1 km; write a shorter length";
  CHECK(length_fault("\"1000.000001 m\"") == "`1000.000001 m`" + large);
  CHECK(length_fault("\"99999999999999999999 m\"") == "`99999999999999999999 m`" + large);
  CHECK(length_fault("\"0 mm\"") == "`0 mm` is no length above 0; write a longer length");
  CHECK(length_fault("300") == "expected a length such as `300 mm`, but found the number `300`");
}

TEST_CASE("A speed is a whole number of micrometers per second, one in m/min is rounded down") {
  CHECK(um_per_s("0.4 m/s") == 400'000);
  CHECK(um_per_s("400mm/s") == 400'000);
  CHECK(um_per_s("24 m/min") == 400'000);
  CHECK(um_per_s("10 m/min") == 166'666);
  CHECK(um_per_s("100 m/s") == 100'000'000);
  CHECK(um_per_s("0.001 mm/s") == 1);
}

TEST_CASE("An invalid, a too fine, a too high and a zero speed have different messages") {
  const std::string none = "` is not a speed; write a number and mm/s, m/s or m/min, such as `0.4 m/s`";
  CHECK(speed_fault("\"4 m\"") == ": `4 m" + none);
  CHECK(speed_fault("\"4 km/h\"") == ": `4 km/h" + none);
  CHECK(speed_fault("\"-1 m/s\"") == ": `-1 m/s" + none);
  CHECK(speed_fault("\"0.0001 mm/s\"") == ": `0.0001 mm/s` has a part below 1 um/s (1 um/min); give it fewer decimals");
  CHECK(speed_fault("\"100.001 m/s\"") == ": `100.001 m/s` is faster than the maximum of 100 m/s; write a lower speed");
  CHECK(speed_fault("0.5") ==
        ": expected a speed such as `0.4 m/s`, or an object with `of` and `unit`, but found the number `0.5`");
  CHECK(speed_fault("\"0 m/s\"") == ": `0 m/s` is below 1 um/s; write a higher speed");
  CHECK(speed_fault("\"0.00005 m/min\"") == ": `0.00005 m/min` is below 1 um/s; write a higher speed");
  CHECK(speed_fault(R"({"of": "A", "unit": "1 s"})") == "/unit: `1 s" + none);
  CHECK(speed_fault(R"({"of": "A"})").find("`unit` is missing here") != std::string::npos);
}

TEST_CASE("A track's keys are read") {
  const GivenMaterial material = sound_material(R"("tracks": {"{self}_T": {"for": "*_CV?", "length": "3 m",
    "gap": "5 mm", "drives": [{"until": "1.5 m", "forward": "A"  , "speed": "0.4 m/s"},
                              {"backward": "B", "speed": {"of": "S", "unit": "0.01 m/s"}}],
    "stops": [{"at": "1.4 m", "when": "C"}],
    "sensors": [{"symbol": "X", "at": "0 m"},
                {"symbol": "Y", "at": "3 m", "kinds": ["a", "b"], "inverted": true},
                {"symbol": "Z", "at": "1 m", "reads": "number"}],
    "end": [{"to": "T2", "when": "D"}, {"to": "out"}]}})");
  REQUIRE(material.tracks.size() == 1);
  const description::GivenTrack& t = material.tracks[0];
  CHECK(t.name == "{self}_T");
  CHECK(t.of == "*_CV?");
  CHECK(t.length == 3'000'000);
  CHECK(t.gap == 5'000);
  REQUIRE(t.drives.size() == 2);
  CHECK(t.drives[0].until == 1'500'000);
  CHECK(t.drives[0].forward == "A");
  CHECK(t.drives[0].backward == "");
  CHECK(t.drives[0].speed.of == "");
  CHECK_FALSE(t.drives[1].until);
  CHECK(t.drives[1].backward == "B");
  CHECK(t.drives[1].speed.of == "S");
  CHECK(t.drives[1].speed.speed == 10'000);
  REQUIRE(t.stops.size() == 1);
  CHECK(t.stops[0].at == 1'400'000);
  CHECK(t.stops[0].when == "C");
  REQUIRE(t.sensors.size() == 3);
  CHECK(t.sensors[0].at == 0);
  CHECK(t.sensors[0].kinds.empty());
  CHECK_FALSE(t.sensors[0].inverted);
  CHECK(t.sensors[1].kinds == std::vector<std::string>{"a", "b"});
  CHECK(t.sensors[1].inverted);
  CHECK(t.sensors[1].reads == tables::SensorReads::part);
  CHECK(t.sensors[2].reads == tables::SensorReads::number);
  REQUIRE(t.ends.size() == 2);
  CHECK(t.ends[0].to == "T2");
  CHECK(t.ends[0].when == "D");
  CHECK(t.ends[1].when == "");
}

TEST_CASE("Places, transfers, work and sources are read") {
  const GivenMaterial material = sound_material(R"("kinds": {"k": {"length": "1 mm", "code": 7}},
    "places": {"P": {"holds": 3, "for": "*", "sensors": [{"symbol": "X", "reads": "code"}]}},
    "transfers": [{"name": "t", "for": "*", "from": "A@1 m", "to": "out", "when": "C", "once": true}],
    "work": [{"name": "w", "for": "*", "at": "P", "when": "C", "from": "k", "to": "l"}],
    "sources": [{"name": "s", "for": "*", "at": "P", "kind": "k", "every": "10s", "first": "1 min", "when": "C",
                 "count": 18446744073709551615}, {"name": "r", "at": "P", "kind": ["k", "l"]}])");
  CHECK(material.kinds.at(0).code == 7);
  const description::GivenPlace& place = material.places.at(0);
  CHECK(place.holds == 3);
  CHECK(place.of == "*");
  CHECK(place.sensors.at(0).symbol == "X");
  CHECK(place.sensors[0].reads == tables::SensorReads::code);
  const description::GivenTransfer& transfer = material.transfers.at(0);
  CHECK(transfer.name + transfer.of + transfer.from + transfer.to + transfer.when == "t*A@1 moutC");
  CHECK(transfer.once);
  const description::GivenWork& work = material.work.at(0);
  CHECK(work.name + work.of + work.at + work.when + work.from + work.to == "w*PCkl");
  const description::GivenSource& source = material.sources.at(0);
  CHECK(source.name + source.of + source.at + source.when == "s*PC");
  CHECK(source.kinds == std::vector<std::string>{"k"});
  CHECK(source.every == Duration::fixed(10 * tables::kSecond));
  CHECK(source.first == 60 * tables::kSecond);
  CHECK(source.count == 18'446'744'073'709'551'615U);
  CHECK(material.sources.at(1).kinds == std::vector<std::string>{"k", "l"});
  CHECK_FALSE(material.sources[1].every);
  CHECK_FALSE(material.sources[1].count);
}

TEST_CASE("Kinds, tracks and places keep the order of the file") {
  const GivenMaterial material = sound_material(
      R"("places": {"b": {}, "a~/": {}, "c": {}}, "kinds": {"z": {"length": "1 m"}, "a": {"length": "2 m"}})");
  REQUIRE(material.places.size() == 3);
  CHECK(material.places[0].name + material.places[1].name + material.places[2].name == "ba~/c");
  CHECK(material.kinds.at(0).name == "z");
  CHECK(material.kinds.at(1).length == 2'000'000);
}

TEST_CASE("A source has a time between parts") {
  const auto every = [](const std::string& value) {
    return material_faults(R"("sources": [{"name": "s", "at": "P", "kind": "k", "every": )" + value + "}]");
  };
  CHECK(every(R"({"min": "0s", "max": "1s"})") == "");
  CHECK(every("\"0s\"") ==
        "/material/sources/0/every: a source cannot make parts every 0 ns; write a longer time, or remove `every`");
  CHECK(every("\"1 sec\"").starts_with("/material/sources/0/every: `1 sec` is not a duration"));
}

TEST_CASE("Numbers have limits, and lists entries") {
  const auto fails = [](const std::string& members, const std::string& pointer) {
    CAPTURE(members);
    CHECK(material_faults(members).starts_with(pointer + ": "));
  };
  fails(R"("kinds": {"k": {"length": "1 m", "code": 65536}})", "/material/kinds/k/code");
  fails(R"("kinds": {"k": {"length": "1 m", "code": -1}})", "/material/kinds/k/code");
  fails(R"("kinds": {"k": {}})", "/material/kinds/k");
  fails(R"("places": {"P": {"holds": 0}})", "/material/places/P/holds");
  fails(R"("places": {"P": {"holds": 1001}})", "/material/places/P/holds");
  fails(track(R"("drives": [])"), "/material/tracks/T/drives");
  fails(R"("tracks": {"T": {"length": "1 m"}})", "/material/tracks/T");
  fails(R"("sources": [{"name": "s", "at": "P", "kind": []}])", "/material/sources/0/kind");
  fails(R"("sources": [{"name": "s", "at": "P", "kind": "k", "count": 0}])", "/material/sources/0/count");
  fails(R"("transfers": [{"name": "", "from": "P", "to": "T"}])", "/material/transfers/0/name");
  fails(R"("work": [{"name": "w", "at": "P", "from": "k", "to": "l"}])",
        (description::Pointer("/material") / "work" / 0).text());
  fails(R"("places": {"P": {"sensors": [{"symbol": "X", "at": "1 m"}]}})", "/material/places/P/sensors/0/at");
  fails(R"("places": {"P": {"sensors": [{"symbol": "X", "kinds": []}]}})", "/material/places/P/sensors/0/kinds");
  fails(R"("places": {"P": {"sensors": [{"symbol": "X", "reads": "kind"}]}})", "/material/places/P/sensors/0/reads");
}

TEST_CASE("Stops and sensors of a track have a position, stops a condition") {
  const std::string drives = R"("drives": [{"forward": "A", "speed": "1 m/s"}], )";
  CHECK(material_faults(track(drives + R"("stops": [{"at": "1 m"}])")).find("`when` is missing") != std::string::npos);
  CHECK(material_faults(track(drives + R"("stops": [{"when": "A"}])")).find("`at` is missing") != std::string::npos);
  CHECK(material_faults(track(drives + R"("sensors": [{"symbol": "A"}])")).find("`at` is missing") !=
        std::string::npos);
}

TEST_CASE("Names of the material flow have no control characters") {
  CHECK(material_faults(R"("places": {"a\nb": {}}, "transfers": [{"name": "a\tb", "from": "P", "to": "T"}])").size() >
        100);
}

}  // namespace
}  // namespace symplant::test
