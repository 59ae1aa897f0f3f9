// The material flow in words.
#include "elements/material/words.hpp"

#include <fmt/format.h>

#include "model/condition_text.hpp"
#include "view/words.hpp"

namespace symplant::view {
namespace {

constexpr std::int64_t kMillimeter = 1'000;
constexpr std::int64_t kMeter = 1'000'000;

}  // namespace

std::string length_text(std::int64_t micrometers) {
  const auto in = [&](std::int64_t unit, std::string_view word) {
    return fmt::format("{} {}", static_cast<double>(micrometers) / static_cast<double>(unit), word);
  };
  if (micrometers >= kMeter) return in(kMeter, "m");
  return micrometers >= kMillimeter || micrometers == 0 ? in(kMillimeter, "mm") : in(1, "um");
}

std::string MaterialWords::kind(const model::PartKind& kind) const {
  return fmt::format("{}: {}{}", kind.name, length_text(kind.length),
                     kind.code == 0 ? std::string() : fmt::format(", code {}", kind.code));
}

std::string MaterialWords::track(const model::Track& track) const {
  return fmt::format("{}: {}{}", track.name, length_text(track.length),
                     track.gap == 0 ? std::string() : ", gap " + length_text(track.gap));
}

std::string MaterialWords::place(const model::Place& place) const {
  return fmt::format("{}: holds {}", place.name, place.holds);
}

std::string MaterialWords::drive(const model::Drive& drive) const {
  const auto direction = [&](std::string_view word, const std::optional<condition::Tree>& tree) {
    return tree ? fmt::format(", {} when {}", word, condition(*tree)) : std::string();
  };
  std::string speed = length_text(drive.speed) + "/s";
  if (drive.symbol != model::kNone) speed = fmt::format("{} times {}", plant_.symbols[drive.symbol].name(), speed);
  if (drive.output != model::kNone) speed = fmt::format("{} times {}", model::output_name(plant_, drive.output), speed);
  if (model::runs_always(drive)) return speed + ", always forward";
  return speed + direction("forward", drive.forward) + direction("backward", drive.backward);
}

std::string MaterialWords::sensor(const model::PartSensor& sensor) const {
  std::string text(plant_.symbols[sensor.symbol].name());
  if (sensor.reads == tables::SensorReads::code) text += ", reads the code";
  if (sensor.reads == tables::SensorReads::number) text += ", reads the number";
  if (!sensor.kinds.empty()) text += ", sees " + kinds(sensor.kinds);
  return plant_.symbols[sensor.symbol].inverted ? text + ", inverted" : text;
}

std::string MaterialWords::end(const model::TrackEnd& end) const { return name(end.to) + when(end.condition); }

std::string MaterialWords::transfer(const model::Transfer& transfer) const {
  return fmt::format("{}: {} to {}{}{}", transfer.name, location(transfer.from), location(transfer.to),
                     when(transfer.condition), transfer.once ? ", once" : "");
}

std::string MaterialWords::work(const model::Work& work) const {
  return fmt::format("{}: {} to {} at {}, when {}", work.name, material_.kinds[work.from].name,
                     material_.kinds[work.to].name, location(work.at), condition(work.condition));
}

std::string MaterialWords::source(const model::Source& source) const {
  return fmt::format(
      "{}: {} at {}{}{}{}{}", source.name, kinds(source.kinds), location(source.to),
      source.every ? ", every " + duration_text(*source.every) : std::string(),
      source.first == 0 ? std::string() : ", first at " + duration_text(description::Duration::fixed(source.first)),
      when(source.condition), source.count ? fmt::format(", at most {}", *source.count) : std::string());
}

std::string MaterialWords::condition(const condition::Tree& tree) const { return model::condition_text(tree, plant_); }

std::string MaterialWords::when(const std::optional<condition::Tree>& tree) const {
  return tree ? ", when " + condition(*tree) : std::string();
}

std::string MaterialWords::location(const tables::PartLocation& at) const {
  return at.at == tables::kWhole ? name(at.location) : fmt::format("{}@{}", name(at.location), length_text(at.at));
}

std::string MaterialWords::name(std::uint32_t location) const {
  return location == tables::kOut ? "out" : material_.location_name(location);
}

std::string MaterialWords::kinds(const std::vector<std::uint32_t>& kinds) const {
  std::string text;
  for (const std::uint32_t kind : kinds) text.append(text.empty() ? "" : ", ").append(material_.kinds[kind].name);
  return text;
}

std::vector<std::string> material_lines(const model::PlantModel& plant) {
  const model::Material& material = plant.material;
  std::vector<std::string> lines;
  if (material.empty()) return lines;
  const MaterialWords words(plant);
  for (const model::PartKind& kind : material.kinds) lines.push_back("kind " + words.kind(kind));
  for (const model::Track& track : material.tracks) {
    lines.push_back("track " + words.track(track));
    for (const model::Drive& drive : track.drives) {
      lines.push_back(fmt::format("  drive up to {}, {}", length_text(drive.until), words.drive(drive)));
    }
    for (const model::Stop& stop : track.stops) {
      lines.push_back(fmt::format("  stop at {}, when {}", length_text(stop.at), words.condition(stop.condition)));
    }
    for (const model::PartSensor& sensor : track.sensors) {
      lines.push_back(fmt::format("  sensor at {}: {}", length_text(sensor.at), words.sensor(sensor)));
    }
    for (const model::TrackEnd& end : track.ends) lines.push_back("  end: " + words.end(end));
    if (track.ends.empty()) lines.emplace_back("  end: parts stop");
  }
  for (const model::Place& place : material.places) {
    lines.push_back("place " + words.place(place));
    for (const model::PartSensor& sensor : place.sensors) lines.push_back("  sensor " + words.sensor(sensor));
  }
  for (const model::Transfer& transfer : material.transfers) lines.push_back("transfer " + words.transfer(transfer));
  for (const model::Work& work : material.work) lines.push_back("work " + words.work(work));
  for (const model::Source& source : material.sources) lines.push_back("source " + words.source(source));
  return lines;
}

}  // namespace symplant::view
