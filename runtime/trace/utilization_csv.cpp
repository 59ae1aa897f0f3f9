// The utilization of a plant as comma-separated values.
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "symplant/trace/csv_text.hpp"
#include "symplant/trace/utilization_text.hpp"

namespace symplant::trace {
namespace {

double seconds_of(tables::Time time) { return static_cast<double>(time) / 1e9; }

/// The lines of one element.
class Lines {
 public:
  Lines(std::string& csv, tables::Time whole) : csv_(csv), whole_(whole) {}

  void of(std::string_view kind, std::string_view name) { begin_ = csv_cell(kind) + "," + csv_cell(name); }
  /// A part of the time.
  void time(std::string_view measure, std::string_view of, tables::Time time) {
    put(measure, of);
    put_time(time);
    csv_ += ",,,,,\n";
  }
  /// A part of the time, and durations.
  void time(std::string_view measure, std::string_view of, tables::Time time, const Durations& durations) {
    put(measure, of);
    put_time(time);
    put_durations(durations);
  }
  void durations(std::string_view measure, std::string_view of, const Durations& durations) {
    put(measure, of);
    csv_ += ",,";
    put_durations(durations);
  }
  void count(std::string_view measure, std::string_view of, std::uint64_t count) {
    put(measure, of);
    csv_ += fmt::format(",,,{},,,,\n", count);
  }

 private:
  void put(std::string_view measure, std::string_view of) {
    csv_ += begin_ + "," + csv_cell(measure) + "," + csv_cell(of);
  }
  void put_time(tables::Time time) {
    const double share = whole_ == 0 ? 0 : 100 * static_cast<double>(time) / static_cast<double>(whole_);
    csv_ += fmt::format(",{},{:.3f}", seconds_of(time), share);
  }
  void put_durations(const Durations& of) {
    if (of.count == 0) {
      csv_ += ",0,,,,\n";
    } else {
      csv_ += fmt::format(",{},{},{},{},{}\n", of.count, seconds_of(of.least), seconds_of(of.mean()),
                          seconds_of(of.greatest), seconds_of(of.last));
    }
  }

  std::string& csv_;
  std::string begin_;
  tables::Time whole_;
};

void put_device(Lines& lines, const PlantNames& names, std::uint32_t unit, const DeviceUse& use,
                bool with_malfunctions) {
  lines.of("device", names.unit(unit));
  for (std::size_t i = 0; i < kActivities; ++i) lines.time("activity", kActivityNames[i], use.times[i]);
  if (with_malfunctions) lines.time("malfunction", "", use.malfunction);
  for (std::size_t state = 0; state < use.states.size(); ++state) {
    lines.time("state", names.state(unit, static_cast<std::uint8_t>(state)), use.states[state]);
  }
  for (const MoveUse& move : use.moves) {
    lines.time("move", fmt::format("{} to {}", names.state(unit, move.from), names.state(unit, move.to)), move.time,
               move.whole);
  }
  if (use.cycle) lines.durations("cycle", names.state(unit, use.cycle->state), use.cycle->times);
}

void put_location(Lines& lines, const tables::MaterialTables& material, const PlantNames& names, std::uint32_t location,
                  const LocationUse& use) {
  lines.of(material.is_track(location) ? "track" : "place", names.location(location));
  for (std::size_t i = 0; i < kOccupations; ++i) {
    const bool starved = i == static_cast<std::size_t>(Occupation::empty) && use.starves;
    lines.time("occupation", starved ? "starved" : kOccupationNames[i], use.times[i]);
  }
  lines.count("parts", "came", use.came);
  lines.count("parts", "left", use.left);
  if (use.exits.events == 0) return;
  lines.count("parts", "left the plant", use.exits.events);
  lines.durations("cycle", "left the plant", use.exits.between);
}

}  // namespace

std::string utilization_csv(const Utilization& utilization, tables::Time now, bool with_malfunctions) {
  const PlantNames& names = utilization.names();
  const tables::PlantTables& tables = names.tables();
  std::string csv =
      fmt::format("{}time [s],share [%],count,least [s],mean [s],greatest [s],last [s]\n", kUtilizationHead);
  Lines lines(csv, now - utilization.from());
  for (std::uint32_t unit = 0; unit < tables.units.size(); ++unit) {
    put_device(lines, names, unit, utilization.device(unit, now), with_malfunctions);
  }
  for (std::uint32_t location = 0; location < tables.material.locations(); ++location) {
    put_location(lines, tables.material, names, location, utilization.parts().location(location, now));
  }
  if (!tables.material.empty()) {
    lines.of("plant", tables.name);
    lines.count("parts", "left the plant", utilization.parts().exits().events);
    lines.durations("cycle", "left the plant", utilization.parts().exits().between);
  }
  return csv;
}

}  // namespace symplant::trace
