// The material flow in words, for tables, notes and drawings.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::view {

/// `1.5 m`, `20 mm`, `7 um`.
std::string length_text(std::int64_t micrometers);

/// The words of the elements of a plant's material flow, without positions. The plant must outlive it.
class MaterialWords {
 public:
  explicit MaterialWords(const model::PlantModel& plant) : plant_(plant), material_(plant.material) {}

  std::string kind(const model::PartKind& kind) const;          ///< `raw: 200 mm, code 1`
  std::string track(const model::Track& track) const;           ///< `CV1: 2 m, gap 10 mm`
  std::string place(const model::Place& place) const;           ///< `FIX: holds 2`
  std::string drive(const model::Drive& drive) const;           ///< `400 mm/s, forward when L_P_CV.RUN`
  std::string sensor(const model::PartSensor& sensor) const;    ///< `L_P_PE_I_ON, sees raw, inverted`
  std::string end(const model::TrackEnd& end) const;            ///< `FIX, when L_P_CV.RUN`
  std::string transfer(const model::Transfer& transfer) const;  ///< `pick: CV1@1 m to out, when L_P_CV.RUN, once`
  std::string work(const model::Work& work) const;              ///< `mill: raw to done at FIX, when L_P_CV.RUN`
  std::string source(const model::Source& source) const;        ///< `feed: raw at CV1, every 1 s, at most 3`
  std::string condition(const condition::Tree& tree) const;
  std::string when(const std::optional<condition::Tree>& tree) const;  ///< `, when L_P_CV.RUN`, or nothing
  std::string location(const tables::PartLocation& at) const;          ///< `CV1@1 m`
  std::string name(std::uint32_t location) const;                      ///< `CV1`, `out`
  std::string kinds(const std::vector<std::uint32_t>& kinds) const;    ///< `raw, done`

 private:
  const model::PlantModel& plant_;
  const model::Material& material_;
};

/// One line for each track, place, transfer, work and source. Indented lines follow that of a track or place: one for
/// each of its drives, stops, sensors and ends. Empty without material. O(material).
std::vector<std::string> material_lines(const model::PlantModel& plant);

}  // namespace symplant::view
