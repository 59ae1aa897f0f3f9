// Resolves the names, locations and conditions in entries of the material flow, and reports those that are invalid.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "elements/material/entries.hpp"
#include "model/plant_names.hpp"

namespace symplant::model {

/// Looks up names, entry by entry. An empty text means that a required text is missing, which the reader of plant.json
/// has reported. If an entry with `for` names something that the plant lacks, that is not a fault: lacking() describes
/// it.
class MaterialLookup {
 public:
  /// The plant's units have their states, its kinds of parts are complete, and its tracks and places have their names
  /// and lengths. `rejected`: names of tracks and places that are left out, since they are the names of devices.
  MaterialLookup(const PlantModel& plant, const text::ByName<bool>& rejected, description::Faults& faults);

  /// Begins an entry. Returns its location.
  description::Pointer begin(std::string_view list, const MadeBy& by);
  bool made_for_device() const { return made_for_device_; }
  /// What the entry names and the plant lacks; empty: nothing.
  const std::string& lacking() const { return lacking_; }
  description::Faults& faults() { return faults_; }
  const PlantModel& plant() const { return plant_; }

  /// False if the text is empty, or, with a fault, if it is not a condition of this plant.
  bool condition(const std::string& text, const description::Pointer& here, condition::Tree& tree);
  /// Nothing if the text is empty or has a fault.
  std::optional<condition::Tree> condition(const std::string& text, const description::Pointer& here);
  /// The numeric symbol or the value that gives a drive its speed; a fault if the plant has no such name.
  void number(const std::string& name, const description::Pointer& here, Drive& drive);
  /// A symbol that mark_sensors() marked; kNone for others, which it has reported.
  std::uint32_t sensor_symbol(const std::string& name) const;
  /// kNone, and a fault, if there is no such kind of part.
  std::uint32_t kind(const std::string& name, const description::Pointer& here);
  /// TRACK, TRACK@POSITION or PLACE; its location is kOut, with a fault, for other texts.
  tables::PartLocation location(const std::string& text, const description::Pointer& here);
  /// Like location(), or `out`.
  tables::PartLocation target(const std::string& text, const description::Pointer& here);
  /// TRACK, PLACE or `out`.
  std::uint32_t end(const std::string& text, const description::Pointer& here);

 private:
  void unknown(const description::Pointer& here, std::string message);
  tables::PartLocation position(std::uint32_t location, std::string_view text, const description::Pointer& here);
  std::string nearest_location(std::string_view name) const;

  const PlantModel& plant_;
  const text::ByName<bool>& rejected_;
  description::Faults& faults_;
  PlantNames names_;
  bool made_for_device_ = false;
  std::string lacking_;
};

/// Whether a text is the target `out`.
bool is_out(std::string_view text);

/// A fault, if a position on a track is beyond its end.
void check_position(const Track& track, std::int64_t at, const description::Pointer& here, description::Faults& faults);

}  // namespace symplant::model
