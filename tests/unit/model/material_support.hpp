// Shared parts of the tests of the material flow: a small line with parts, and its model as text.
#pragma once

#include <string>
#include <vector>

#include "description/plant_file.hpp"
#include "description_support.hpp"
#include "model/condition_text.hpp"

namespace symplant::test {

/// Cells S_10 and S_20, each with a conveyor CV1 and a stopper STP1; light barriers PE1 and PE2, a reader of codes and
/// a fixture in S_10.
inline std::vector<Row> line_rows() {
  std::vector<Row> rows =
      bits({"S_10_CV1_O_RUN", "S_10_CV1_I_RUN", "S_10_STP1_O_ADV", "S_10_STP1_I_ADV", "S_10_STP1_O_RET",
            "S_10_STP1_I_RET", "S_20_CV1_O_RUN", "S_20_CV1_I_RUN", "S_20_STP1_O_ADV", "S_20_STP1_I_ADV",
            "S_20_STP1_O_RET", "S_20_STP1_I_RET", "S_10_PE1_I_PART*", "S_10_PE2_I_TALL", "S_10_FIX1_I_PART",
            "S_10_STP1_I_PART", "S_20_STP1_I_PART", "S_10_BTN_I_START"});
  rows.push_back({"S_10_RFID_I_CODE", "", "INT", "0", "%IW40"});
  rows.push_back({"S_10_CV1_O_SPEED", "", "INT", "0", "%QW40"});
  return rows;
}

inline description::Description read_description(const std::string& members) {
  auto reading = description::read_plant_file("{\"symplant\": 1, \"symbols\": [\"a.csv\"], " + members + "}", "stem");
  for (const description::DescriptionFault& fault : reading.faults) {
    FAIL_CHECK(fault.pointer << ": " << fault.message);
  }
  for (const json::Placed& fault : reading.syntax) FAIL_CHECK(fault.message);
  REQUIRE(reading.file);
  return std::move(reading.file->description);
}

/// The line with these members of `material`, and further members of plant.json.
inline Analysed line_with(const std::string& material, const std::string& members = "",
                          const std::vector<Row>& rows = line_rows()) {
  return analyse_described(
      rows, read_description("\"material\": {" + material + "}" + (members.empty() ? "" : ", ") + members));
}

/// Kinds `raw`, `done` (200 mm) and `tall` (300 mm).
inline std::string kinds() {
  return R"("kinds": {"raw": {"length": "200 mm", "code": 1}, "done": {"length": "20 cm", "code": 2},
            "tall": {"length": "0.3 m"}})";
}

/// The kinds, a track T of 3 m, a place P, and these members.
inline Analysed line_of(const std::string& material, const std::string& members = "") {
  return line_with(kinds() + R"(, "tracks": {"T": {"length": "3 m", "drives": [{"forward": "S_10_CV1.RUN",
                   "speed": "0.5 m/s"}]}}, "places": {"P": {}})" +
                       (material.empty() ? "" : ", ") + material,
                   members);
}

/// The kinds, and a track T of 3 m with a drive and these members.
inline Analysed track_with(const std::string& members, const std::string& further = "") {
  return line_with(kinds() + R"(, "tracks": {"T": {"length": "3 m", )" + members +
                   R"(, "drives": [{"forward": "S_10_CV1.RUN", "speed": "0.5 m/s"}]}})" +
                   (further.empty() ? "" : ", ") + further);
}

inline std::string material_warnings(const Analysed& analysed) {
  std::string text;
  for (const description::DescriptionFault& fault : analysed.evidence().warnings) {
    text += (text.empty() ? "" : "\n") + fault.pointer + ": " + fault.message;
  }
  return text;
}

inline std::string text_of(const std::optional<condition::Tree>& tree, const model::PlantModel& plant) {
  return tree ? model::condition_text(*tree, plant) : "-";
}

inline std::string text_of(const tables::PartLocation& at, const model::PlantModel& plant) {
  if (at.location == tables::kOut) return "out";
  return plant.material.location_name(at.location) + (at.at == tables::kWhole ? "" : "@" + std::to_string(at.at));
}

/// "T 3000000 gap 0: ..1500000 A.RUN / - 400000; ..."
inline std::string drives_text(const Analysed& analysed, std::size_t track = 0) {
  const model::PlantModel& plant = analysed.model();
  const model::Track& of = plant.material.tracks.at(track);
  std::string text = of.name + " " + std::to_string(of.length) + " gap " + std::to_string(of.gap) + ":";
  for (const model::Drive& drive : of.drives) {
    text += " .." + std::to_string(drive.until) + " " + text_of(drive.forward, plant) + " / " +
            text_of(drive.backward, plant) + " " + std::to_string(drive.speed);
    if (drive.symbol != model::kNone) text += " * " + std::string(plant.symbols[drive.symbol].name());
    text += ";";
  }
  return text;
}

/// "S_10_PE1_I_PART@300000 0,2 reads 0; ..."
inline std::string sensors_text(const Analysed& analysed, const std::vector<model::PartSensor>& sensors) {
  std::string text;
  for (const model::PartSensor& sensor : sensors) {
    text += std::string(analysed.model().symbols[sensor.symbol].name()) + "@" + std::to_string(sensor.at);
    for (const std::uint32_t kind : sensor.kinds) text += " " + analysed.model().material.kinds.at(kind).name;
    text += " reads " + std::to_string(static_cast<int>(sensor.reads)) + ";";
  }
  return text;
}

/// Names of tracks, places, transfers, work and sources.
inline std::string names_text(const Analysed& analysed) {
  const model::Material& material = analysed.model().material;
  std::string text;
  const auto add = [&](const auto& elements) {
    for (const auto& element : elements) text += element.name + " ";
    text += "| ";
  };
  add(material.tracks);
  add(material.places);
  add(material.transfers);
  add(material.work);
  add(material.sources);
  return text.substr(0, text.size() - 3);  // without the last bar
}

}  // namespace symplant::test
