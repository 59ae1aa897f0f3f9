// Where the parts of a trace were on their tracks.
#include "symplant/panel/recording/stays.hpp"

#include <algorithm>

namespace symplant::panel {

using trace::Record;

Stays::Stays(const std::vector<Record>& records, const trace::PlantNames& names) : names_(names) {
  const tables::MaterialTables& material = names.tables().material;
  for (std::uint32_t i = 0; i < material.sensors.size(); ++i) {
    const tables::SensorRow& sensor = material.sensors[i];
    const bool is_bit = names.tables().symbols[sensor.symbol].type() == tables::DataType::boolean;
    if (is_bit && material.is_track(sensor.location)) sensors_[sensor.symbol] = i;
  }
  Record part{};
  for (const Record& record : records) {
    if (record.kind == Record::Kind::part) part = record;
    if (record.kind == Record::Kind::part_move) moved(trace::part_record(part, record));
    if (record.kind == Record::Kind::change) seen(record);
  }
  for (auto& [number, track] : tracks_) track.first = 0;
}

std::uint32_t Stays::track_of(std::uint32_t symbol) const {
  const auto found = sensors_.find(symbol);
  return found == sensors_.end() ? tables::kNone : names_.tables().material.sensors[found->second].location;
}

std::span<Stays::Stay> Stays::since(Track& track, tables::Time time) {
  while (track.first < track.stays.size() && track.stays[track.first].to <= time) ++track.first;
  return std::span(track.stays).subspan(track.first);
}

void Stays::pin(Stay& stay, Pin pin) {
  if (pin.time > stay.pins.back().time && pin.x >= stay.pins.back().x) stay.pins.push_back(pin);
}

void Stays::moved(const trace::PartRecord& part) {
  const tables::MaterialTables& material = names_.tables().material;
  if (part.changed()) return;
  if (const auto open = open_.find(part.number); open != open_.end()) {
    const auto& [track, index] = open->second;
    Stay& stay = tracks_[track].stays[index];
    stay.to = part.time;
    pin(stay, {part.time, material.tracks[track].length});
    open_.erase(open);
  }
  if (part.to == tables::kOut || part.to == tables::kNone || !material.is_track(part.to)) return;
  std::vector<Stay>& stays = tracks_[part.to].stays;
  open_[part.number] = {part.to, stays.size()};
  stays.push_back({part.number, part.kind, tables::kNever, {{part.time, part.x}}});
}

void Stays::seen(const Record& change) {
  const auto found = sensors_.find(change.of);
  if (found == sensors_.end()) return;
  const tables::MaterialTables& material = names_.tables().material;
  const tables::SensorRow& sensor = material.sensors[found->second];
  const bool begins = (change.value != 0) != names_.tables().symbols[change.of].inverted();
  const auto passes = [&](const Stay& stay) {
    return begins ? sensor.at : sensor.at + material.kinds[stay.kind].length;
  };
  Stay* foremost = nullptr;
  for (Stay& stay : since(tracks_[sensor.location], change.time)) {
    const std::int64_t x = stay.pins.back().x;
    if (stay.to <= change.time || x >= passes(stay) || (!begins && x < sensor.at)) continue;
    if (foremost == nullptr || x > foremost->pins.back().x) foremost = &stay;
  }
  if (foremost == nullptr || passes(*foremost) > material.tracks[sensor.location].length) return;
  pin(*foremost, {change.time, passes(*foremost)});
}

/// The position of a front and its speed in um/s.
std::pair<std::int64_t, std::int32_t> Stays::front(const Stay& stay, tables::Time time) {
  const auto next = std::find_if(stay.pins.begin(), stay.pins.end(), [&](const Pin& pin) { return pin.time > time; });
  const Pin& last = *std::prev(next);
  if (next == stay.pins.end()) return {last.x, 0};
  const double seconds = static_cast<double>(next->time - last.time) / 1e9;
  const double speed = static_cast<double>(next->x - last.x) / seconds;
  const double way = speed * static_cast<double>(time - last.time) / 1e9;
  return {last.x + static_cast<std::int64_t>(way), static_cast<std::int32_t>(speed)};
}

void Stays::append(std::uint32_t track, tables::Time time, std::vector<Record>& records) {
  const auto found = tracks_.find(track);
  if (found == tracks_.end()) return;
  struct Shown {
    std::int64_t x;
    std::int32_t v;
    const Stay* stay;
  };
  std::vector<Shown> parts;
  for (const Stay& stay : since(found->second, time)) {
    if (stay.pins.front().time > time || stay.to <= time) continue;
    const auto [x, v] = front(stay, time);
    parts.push_back({x, v, &stay});
  }
  std::sort(parts.begin(), parts.end(), [](const Shown& a, const Shown& b) { return a.x > b.x; });
  records.push_back({time, parts.size(), track, Record::Kind::track});
  for (const auto& [x, v, stay] : parts) {
    records.push_back({time, stay->number, stay->kind, Record::Kind::part_at});
    records.push_back({time, static_cast<std::uint64_t>(x), static_cast<std::uint32_t>(v), Record::Kind::part_speed});
  }
}

}  // namespace symplant::panel
