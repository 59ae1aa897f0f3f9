// The plan of random material flow, and its conditions.
#include "property/random_material.hpp"

#include <algorithm>
#include <cctype>

namespace symplant::property {
namespace {

bool is_plain(std::string_view name) {
  return std::all_of(name.begin(), name.end(),
                     [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.'; });
}

void draw_kinds(MaterialPlan& plan) {
  static const std::vector<std::string> kNames = {"raw", "done", "tall"};
  const std::size_t count = 1 + plan.dice.below(3);
  for (std::size_t i = 0; i < count; ++i) {
    description::GivenKind& kind = plan.material().kinds.emplace_back();
    kind.name = kNames[i];
    kind.length = plan.unit * (1 + static_cast<std::int64_t>(plan.dice.below(plan.dice.percent(30) ? 6 : 2)));
    if (plan.dice.percent(15)) kind.length = std::max<std::int64_t>(1, kind.length / 2 + 1);
    if (i > 0 && plan.dice.percent(60)) kind.length = plan.material().kinds.front().length;
    kind.code = static_cast<std::uint32_t>(plan.dice.below(5));
  }
}

/// A ring on which a part passes its marks about 10,000 times in a millisecond.
void fast_ring(MaterialPlan& plan) {
  description::GivenTrack& track = plan.material().tracks.emplace_back();
  track.name = "RING";
  track.length = 10 + static_cast<std::int64_t>(plan.dice.below(20));
  track.drives.push_back({{}, "RING.parts >= 0", "", {tables::kMaxSpeed, ""}});
  track.ends.push_back({"RING", ""});
  plan.row("PE4", "BOOL", false);
  track.sensors.push_back({"PE4", static_cast<std::int64_t>(plan.dice.below(10)), {}, false, {}});
  const auto first = static_cast<tables::Time>(plan.dice.below(tables::kMillisecond));
  plan.material().sources.push_back({"s4", "", "RING", {"raw"}, {}, first, "", {}});
}

}  // namespace

std::vector<std::string> atoms_of_plant(const model::PlantModel& model) {
  std::vector<std::string> atoms;
  for (const model::Unit& unit : model.units) {
    if (!is_plain(unit.path) || atoms.size() > 200) continue;
    for (const model::State& state : unit.states) {
      if (is_plain(state.name)) atoms.push_back(std::string(unit.path) + "." + state.name);
    }
  }
  for (const model::Symbol& symbol : model.symbols) {
    if (symbol.type == tables::DataType::boolean) atoms.push_back("'" + std::string(symbol.name()) + "'");
  }
  return atoms;
}

std::string MaterialPlan::location() {
  const std::size_t index = dice.below(tracks.size() + places.size());
  return index < tracks.size() ? tracks[index] : places[index - tracks.size()];
}

std::string MaterialPlan::spot() {
  const std::string name = location();
  const auto track = std::find(tracks.begin(), tracks.end(), name);
  if (track == tracks.end() || dice.percent(40)) return name;
  const std::int64_t length = material().tracks[static_cast<std::size_t>(track - tracks.begin())].length;
  const auto position = static_cast<std::int64_t>(dice.below(static_cast<std::size_t>(length / unit) + 1)) * unit;
  return name + "@" + std::to_string(position) + "um";
}

std::string MaterialPlan::part_atom() {
  static const std::vector<std::string> kCompared = {"> 0", ">= 2", "= 1", "< 3", "= 0", "> 1.5", "<= 4"};
  const std::string name = location();
  const std::size_t kind = dice.below(100);
  if (kind < 40) return name + ".part";
  if (kind < 65) return name + "." + dice.pick(material().kinds).name;
  return name + ".parts " + dice.pick(kCompared);
}

std::string MaterialPlan::switch_atom() {
  if (dice.percent(12)) return location() + ".parts >= 0";
  return "not " + dice.pick(switches);
}

std::string MaterialPlan::atom() {
  static const std::vector<std::string> kCompared = {" = 0", " > 0", " = 1", " = 2", " >= 3"};
  const std::size_t kind = dice.below(100);
  const std::string negated = dice.percent(25) ? "not " : "";
  if (kind < 20) return negated + dice.pick(switches);
  if (kind < 50) return negated + part_atom();
  if (kind < 70 && !bit_sensors.empty()) return negated + dice.pick(bit_sensors);
  if (kind < 80 && !number_sensors.empty()) {
    const std::string& sensor = dice.pick(number_sensors);
    return sensor + dice.pick(kCompared);
  }
  return negated + (plant_atoms.empty() ? part_atom() : dice.pick(plant_atoms));
}

std::string MaterialPlan::condition() {
  if (dice.percent(65)) return atom();
  const std::string joint = dice.percent(60) ? " and " : " or ";
  const std::string left = atom();
  return left + joint + atom();
}

void MaterialPlan::row(const std::string& name, const std::string& type, bool operation) {
  const std::string side = operation ? "%Q" : "%I";
  const std::size_t number = rows++;
  const bool eight = type == "LINT" || type == "LREAL" || type == "ULINT";
  const bool four = type == "DINT" || type == "UDINT" || type == "REAL" || type == "DWORD";
  const std::string address = type == "BOOL" ? "X" + std::to_string(40'000 + number)
                              : eight        ? "L" + std::to_string(13'500 + number)
                              : four         ? "D" + std::to_string(26'000 + number)
                                             : "W" + std::to_string(50'000 + number);
  text.rows.push_back({name, side + address, type, dice.percent(10) ? (type == "BOOL" ? "TRUE" : "1") : ""});
}

void add_random_material(Dice& dice, PlantText& text, const model::PlantModel& model) {
  static const std::vector<std::int64_t> kUnits = {10, 1000, 1000, 10'000, 100'000, 999};
  MaterialPlan plan{dice, text, atoms_of_plant(model), {}};
  plan.unit = dice.pick(kUnits);
  for (const std::string name : {"HALT1", "HALT2", "HALT3"}) {
    if (!plan.switches.empty() && dice.percent(30)) continue;
    plan.switches.push_back(name);
    plan.row(name, "BOOL", true);
    text.rows.back().initial.clear();
  }
  draw_kinds(plan);
  const std::size_t tracks = 1 + dice.below(dice.percent(70) ? 2 : 4);
  for (std::size_t i = 0; i < tracks; ++i) plan.tracks.push_back("CV" + std::to_string(i + 1));
  const std::size_t places = dice.below(3);
  for (std::size_t i = 0; i < places; ++i) plan.places.push_back("BOX" + std::to_string(i + 1));
  draw_tracks(plan);
  draw_places(plan);
  draw_transfers(plan);
  draw_work(plan);
  draw_sources(plan);
  read_parts(plan);
  if (dice.percent(20)) {
    // Rows anywhere in the list.
    for (std::size_t i = text.rows.size() - plan.rows; i < text.rows.size(); ++i) {
      std::swap(text.rows[i], text.rows[dice.below(text.rows.size())]);
    }
  }
}

void add_reversing_tracks(Dice& dice, PlantText& text) {
  MaterialPlan plan{dice, text, {}, {}};
  plan.material().kinds.push_back({"raw", 10, 1});
  for (std::size_t i = 1; i <= 3; ++i) {
    const std::string number = std::to_string(i);
    plan.row("PE" + number, "BOOL", false);
    description::GivenTrack& track = plan.material().tracks.emplace_back();
    track.name = "FLIP" + number;
    track.length = 100;
    const auto speed = static_cast<std::int64_t>(1000 * (1 + dice.below(9)));
    track.drives.push_back({{}, "not PE" + number, "PE" + number, {speed, ""}});
    track.sensors.push_back({"PE" + number, 20 + static_cast<std::int64_t>(dice.below(50)), {}, false, {}});
    plan.material().sources.push_back({"s" + number, "", track.name, {"raw"}, {}, 0, "", {}});
  }
  fast_ring(plan);
}

bool has_reversing_tracks(const model::PlantModel& model) {
  return !model.material.tracks.empty() && model.material.tracks.front().name == "FLIP1";
}

}  // namespace symplant::property
