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

std::vector<std::pair<tables::Time, std::uint32_t>> Stays::turns() const {
  std::vector<std::pair<tables::Time, std::uint32_t>> turns;
  for (const auto& [number, track] : tracks_) {
    for (const Stay& stay : track.stays) {
      for (const Pin& pin : stay.pins) turns.emplace_back(pin.time, number);
    }
  }
  std::sort(turns.begin(), turns.end());
  return turns;
}

std::span<Stays::Stay> Stays::since(Track& track, tables::Time time) {
  while (track.first < track.stays.size() && track.stays[track.first].to <= time) ++track.first;
  return std::span(track.stays).subspan(track.first);
}

/// The constant speed of the drive at a position, in um/s; 0: a symbol gives it.
std::int64_t Stays::speed_at(std::uint32_t track, std::int64_t x) const {
  const tables::MaterialTables& material = names_.tables().material;
  const tables::Rows& rows = material.tracks[track].drives;
  const auto drives = material.drives.subspan(rows.first, rows.count);
  const auto drive = std::find_if(drives.begin(), drives.end(), [x](const auto& row) { return x <= row.until; });
  return drive == drives.end() || drive->symbol != tables::kNone ? 0 : drive->speed;
}

/// A part that took longer than its drive needs was held by the first stop on its path.
void Stays::hold_at_stop(std::uint32_t track, Stay& stay, Pin next) const {
  const tables::MaterialTables& material = names_.tables().material;
  const Pin last = stay.pins.back();
  const tables::Rows& rows = material.tracks[track].stops;
  for (const tables::StopRow& stop : material.stops.subspan(rows.first, rows.count)) {
    if (stop.at <= last.x || stop.at > next.x) continue;
    const std::int64_t speed = speed_at(track, stop.at);
    if (speed == 0) return;
    const auto duration = [speed](std::int64_t distance) { return distance * tables::kSecond / speed; };
    const tables::Time from = last.time + duration(stop.at - last.x);
    const tables::Time until = next.time - duration(next.x - stop.at);
    if (until <= from) return;
    stay.pins.push_back({from, stop.at});
    stay.pins.push_back({until, stop.at});
    return;
  }
}

void Stays::pin(std::uint32_t track, Stay& stay, Pin next) const {
  if (next.time <= stay.pins.back().time || next.x < stay.pins.back().x) return;
  hold_at_stop(track, stay, next);
  if (next.time > stay.pins.back().time) stay.pins.push_back(next);
}

void Stays::moved(const trace::PartRecord& part) {
  const tables::MaterialTables& material = names_.tables().material;
  if (part.changed()) return;
  if (const auto open = open_.find(part.number); open != open_.end()) {
    const auto& [track, index] = open->second;
    Stay& stay = tracks_[track].stays[index];
    stay.to = part.time;
    pin(track, stay, {part.time, material.tracks[track].length});
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
  pin(sensor.location, *foremost, {change.time, passes(*foremost)});
}

/// The position of a front and its speed in um/s.
std::pair<std::int64_t, std::int32_t> Stays::front(const Stay& stay, tables::Time time) {
  const auto next = std::find_if(stay.pins.begin(), stay.pins.end(), [&](const Pin& pin) { return pin.time > time; });
  const Pin& last = *std::prev(next);
  if (next == stay.pins.end()) return {last.x, 0};
  const double seconds = static_cast<double>(next->time - last.time) / 1e9;
  const double speed = static_cast<double>(next->x - last.x) / seconds;
  const double moved = speed * static_cast<double>(time - last.time) / 1e9;
  return {last.x + static_cast<std::int64_t>(moved), static_cast<std::int32_t>(speed)};
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
