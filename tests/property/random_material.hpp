// Random material flow for a drawn plant: kinds, tracks, places, transfers, work, sources, and conditions that name
// them.
#pragma once

#include <string>
#include <vector>

#include "property/dice.hpp"
#include "property/plant_text.hpp"

namespace symplant::property {

/// What is known of a plant while its material is drawn.
struct MaterialPlan {
  Dice& dice;
  PlantText& text;
  std::vector<std::string> plant_atoms;  ///< atoms of conditions on the plant's units and bits
  std::vector<std::string> switches;     ///< BOOL operations that only material reads, off at the start
  std::vector<std::string> bit_sensors = {};
  std::vector<std::string> number_sensors = {};
  std::vector<std::string> tracks = {};
  std::vector<std::string> places = {};
  std::int64_t unit = 1;  ///< um: positions are multiples of it, mostly
  std::size_t rows = 0;   ///< added ones

  description::GivenMaterial& material() { return text.description.material; }
  std::string location();   ///< the name of a track or place
  std::string spot();       ///< a location, some with a position
  std::string part_atom();  ///< LOCATION.part and the like
  std::string atom();
  std::string condition();
  std::string switch_atom();  ///< holds at the start
  /// Adds a row with an address of its type that no other row has.
  void row(const std::string& name, const std::string& type, bool operation);
};

/// Atoms of conditions that name units and bits.
std::vector<std::string> atoms_of_plant(const model::PlantModel& model);

/// Adds material to a plant without it. `model`: of that plant.
void add_random_material(Dice& dice, PlantText& text, const model::PlantModel& model);

/// Tracks on which sensors reverse drives, so that they freeze.
void add_reversing_tracks(Dice& dice, PlantText& text);
/// Whether the plant has such tracks.
bool has_reversing_tracks(const model::PlantModel& model);

// The parts of add_random_material().
void draw_tracks(MaterialPlan& plan);
void draw_places(MaterialPlan& plan);
void draw_transfers(MaterialPlan& plan);
void draw_work(MaterialPlan& plan);
void draw_sources(MaterialPlan& plan);
/// Lets devices, requirements and symbols that follow read parts.
void read_parts(MaterialPlan& plan);

}  // namespace symplant::property
