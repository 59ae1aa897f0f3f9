// The material flow in lines of text.
#include "view/material_words.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <utility>

#include "model/condition_text.hpp"
#include "view/words.hpp"

namespace symplant::view {
namespace {

constexpr std::int64_t kMillimeter = 1'000;
constexpr std::int64_t kMeter = 1'000'000;

class MaterialLines {
 public:
  explicit MaterialLines(const model::PlantModel& plant) : plant_(plant), material_(plant.material) {}

  std::vector<std::string> write() {
    if (material_.empty()) return {};
    for (const model::PartKind& kind : material_.kinds) {
      add("kind {}: {}{}", kind.name, length_text(kind.length),
          kind.code == 0 ? std::string() : fmt::format(", code {}", kind.code));
    }
    for (const model::Track& track : material_.tracks) add_track(track);
    for (const model::Place& place : material_.places) {
      add("place {}: holds {}", place.name, place.holds);
      for (const model::PartSensor& sensor : place.sensors) add("  sensor {}", sensor_text(sensor));
    }
    for (const model::Transfer& transfer : material_.transfers) {
      add("transfer {}: {} to {}{}{}", transfer.name, location(transfer.from), location(transfer.to),
          when(transfer.condition), transfer.once ? ", once" : "");
    }
    for (const model::Work& work : material_.work) {
      add("work {}: {} to {} at {}, when {}", work.name, material_.kinds[work.from].name, material_.kinds[work.to].name,
          location(work.at), model::condition_text(work.condition, plant_));
    }
    for (const model::Source& source : material_.sources) add_source(source);
    return std::move(lines_);
  }

 private:
  template <class... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    lines_.push_back(fmt::format(format, std::forward<Values>(values)...));
  }

  void add_track(const model::Track& track) {
    add("track {}: {}{}", track.name, length_text(track.length),
        track.gap == 0 ? std::string() : ", gap " + length_text(track.gap));
    for (const model::Drive& drive : track.drives) {
      std::string speed = length_text(drive.speed) + "/s";
      if (drive.symbol != model::kNone) speed = fmt::format("{} times {}", plant_.symbols[drive.symbol].name(), speed);
      add("  drive up to {}, {}{}{}", length_text(drive.until), speed, direction("forward", drive.forward),
          direction("backward", drive.backward));
    }
    for (const model::Stop& stop : track.stops) {
      add("  stop at {}, when {}", length_text(stop.at), model::condition_text(stop.condition, plant_));
    }
    for (const model::PartSensor& sensor : track.sensors) {
      add("  sensor at {}: {}", length_text(sensor.at), sensor_text(sensor));
    }
    for (const model::TrackEnd& end : track.ends) add("  end: {}{}", name(end.to), when(end.condition));
    if (track.ends.empty()) add("  end: parts stop");
  }

  void add_source(const model::Source& source) {
    std::string kinds;
    for (const std::uint32_t kind : source.kinds) {
      kinds.append(kinds.empty() ? "" : ", ").append(material_.kinds[kind].name);
    }
    add("source {}: {} at {}{}{}{}{}", source.name, kinds, location(source.to),
        source.every ? ", every " + duration_text(*source.every) : std::string(),
        source.first == 0 ? std::string() : ", first at " + duration_text(description::Duration::fixed(source.first)),
        when(source.condition), source.count ? fmt::format(", at most {}", *source.count) : std::string());
  }

  std::string sensor_text(const model::PartSensor& sensor) const {
    std::string text(plant_.symbols[sensor.symbol].name());
    if (sensor.reads == tables::SensorReads::code) text += ", reads the code";
    if (sensor.reads == tables::SensorReads::number) text += ", reads the number";
    for (std::size_t i = 0; i < sensor.kinds.size(); ++i) {
      text.append(i == 0 ? ", sees " : ", ").append(material_.kinds[sensor.kinds[i]].name);
    }
    return plant_.symbols[sensor.symbol].inverted ? text + ", inverted" : text;
  }

  std::string direction(std::string_view word, const std::optional<condition::Tree>& tree) const {
    return tree ? fmt::format(", {} when {}", word, model::condition_text(*tree, plant_)) : std::string();
  }
  std::string when(const std::optional<condition::Tree>& tree) const {
    return tree ? ", when " + model::condition_text(*tree, plant_) : std::string();
  }
  std::string name(std::uint32_t location) const {
    return location == tables::kOut ? "out" : material_.location_name(location);
  }
  std::string location(const tables::PartLocation& at) const {
    return at.at == tables::kWhole ? name(at.location) : fmt::format("{}@{}", name(at.location), length_text(at.at));
  }

  const model::PlantModel& plant_;
  const model::Material& material_;
  std::vector<std::string> lines_;
};

}  // namespace

std::string length_text(std::int64_t micrometers) {
  const auto in = [&](std::int64_t unit, std::string_view word) {
    return fmt::format("{} {}", static_cast<double>(micrometers) / static_cast<double>(unit), word);
  };
  if (micrometers >= kMeter) return in(kMeter, "m");
  return micrometers >= kMillimeter || micrometers == 0 ? in(kMillimeter, "mm") : in(1, "um");
}

std::vector<std::string> material_lines(const model::PlantModel& plant) { return MaterialLines(plant).write(); }

}  // namespace symplant::view
