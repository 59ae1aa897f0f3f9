// Finds the symbols of sensors of parts, before the symbols are grouped by device.
#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include "elements/material/entries.hpp"
#include "model/classify.hpp"
#include "text/ascii.hpp"

namespace symplant::model {
namespace {

using description::ticked;

/// The largest code of a kind that a number holds.
std::uint32_t most_code(tables::DataType type) {
  switch (type) {
    case tables::DataType::sint:
      return 127;
    case tables::DataType::usint:
    case tables::DataType::byte:
      return 255;
    case tables::DataType::int_:
      return 32'767;
    default:
      return 65'535;
  }
}

class SensorMarker {
 public:
  SensorMarker(PlantModel& plant, MadeMaterial& made, description::Faults& faults)
      : plant_(plant), inverted_(made.inverted), kinds_(made.entries.kinds), faults_(faults) {
    symbols_.reserve(plant.symbols.size());
    for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) symbols_.try_emplace(plant.symbols[i].name(), i);
  }

  template <class Entry>
  void mark_all(const std::vector<Entry>& entries, std::string_view list, std::vector<MadeBy>& origins) {
    for (std::size_t e = 0; e < entries.size(); ++e) {
      const description::Pointer here = material_pointer(list, origins[e]) / "sensors";
      const std::vector<description::GivenSensor>& sensors = entries[e].sensors;
      for (std::size_t s = 0; s < sensors.size(); ++s) look_up(sensors[s], here / s / "symbol", origins[e]);
      if (!origins[e].lacking.empty()) continue;
      for (std::size_t s = 0; s < sensors.size(); ++s) mark(sensors[s], here / s);
    }
  }

 private:
  /// An entry with `for` that names a symbol that the plant lacks is left out as a whole.
  void look_up(const description::GivenSensor& sensor, const description::Pointer& here, MadeBy& by) {
    if (sensor.symbol.empty() || symbols_.contains(sensor.symbol)) return;  // empty: already reported
    std::string message = description::missing("symbol " + ticked(sensor.symbol), nearest(sensor.symbol));
    if (by.pattern.empty()) {
      faults_.add(here, std::move(message), description::FaultKind::unknown_name);
    } else if (by.lacking.empty()) {
      by.lacking = std::move(message);
    }
  }

  void mark(const description::GivenSensor& sensor, const description::Pointer& here) {
    const auto found = symbols_.find(sensor.symbol);
    if (found == symbols_.end()) return;
    Symbol& symbol = plant_.symbols[found->second];
    if (std::string why = why_not(sensor, symbol, found->second); !why.empty()) {
      faults_.add(here / "symbol", ticked(sensor.symbol) + why);
      return;
    }
    if (sensor.inverted && symbol.inverted) {
      faults_.add(here / "inverted",
                  ticked(sensor.symbol) + " is inverted here and in the plant's `inverted`; remove one of the two");
    }
    if (sensor.inverted) inverted_.push_back(found->second);
    marked_.insert(found->second);
    symbol.account = Account::senses_parts;
  }

  std::string why_not(const description::GivenSensor& sensor, const Symbol& symbol, std::uint32_t index) const {
    const bool boolean = symbol.type == tables::DataType::boolean;
    const bool reads = sensor.reads != tables::SensorReads::part;
    if (symbol.direction != tables::Direction::event) return " is an output of the PLC; a sensor drives an input";
    if (marked_.contains(index)) return " belongs to another sensor too; remove one of the two";
    if (symbol.account == Account::follows) {
      return " follows a condition and is a sensor too; remove one of the two";
    }
    if (symbol.account == Account::shows_value) return " shows a formula and is a sensor too; remove one of the two";
    if (boolean && reads) return " is BOOL; remove `reads`";
    if (!boolean && !reads) return " is numeric; add `\"reads\": \"code\"` or `\"reads\": \"number\"`";
    if (!boolean && sensor.inverted) return " is numeric; only BOOL symbols can be `inverted`";
    return sensor.reads == tables::SensorReads::code ? code_too_large(sensor, symbol.type) : std::string();
  }

  /// What to say of a kind whose code the symbol's type does not hold; nothing if there is none.
  std::string code_too_large(const description::GivenSensor& sensor, tables::DataType type) const {
    const std::uint32_t most = most_code(type);
    for (const description::GivenKind& kind : kinds_) {
      const auto& seen = sensor.kinds;
      const bool sees = seen.empty() || std::any_of(seen.begin(), seen.end(), [&](const std::string& name) {
                          return text::equal_ignoring_case(name, kind.name);
                        });
      if (!sees || kind.code <= most) continue;
      return fmt::format(" is of type {}, which holds at most {}; the code of {} is {}; write a smaller code",
                         data_type_name(type), most, ticked(kind.name), kind.code);
    }
    return {};
  }

  std::string_view nearest(std::string_view name) const {
    return faults_.nearest(name, plant_.symbols.size(), [&](std::size_t i) { return plant_.symbols[i].name(); });
  }

  PlantModel& plant_;
  std::vector<std::uint32_t>& inverted_;
  const std::vector<description::GivenKind>& kinds_;
  description::Faults& faults_;
  text::ByName<std::uint32_t> symbols_;
  std::unordered_set<std::uint32_t> marked_;
};

}  // namespace

void mark_sensors(PlantModel& plant, MadeMaterial& made, description::Faults& faults) {
  SensorMarker marker(plant, made, faults);
  marker.mark_all(made.entries.tracks, "tracks", made.tracks);
  marker.mark_all(made.entries.places, "places", made.places);
}

}  // namespace symplant::model
