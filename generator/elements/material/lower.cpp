// Lowers the material flow: its elements as rows, in their order.
#include "elements/material/lower.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lower/random_time.hpp"

namespace symplant::lower {
namespace {

using model::kNone;

template <class T>
std::uint32_t size_of(const std::vector<T>& rows) {
  return static_cast<std::uint32_t>(rows.size());
}

void add_name(std::string& names, std::string_view name) { names.append(name).push_back('\0'); }

class MaterialLowering {
 public:
  MaterialLowering(const model::Material& material, const AddCondition& add_condition, EngineTables& tables)
      : material_(material), add_condition_(add_condition), tables_(tables), rows_(tables.material) {}

  void run() {
    for (const model::PartKind& kind : material_.kinds) {
      rows_.kinds.push_back({kind.length, kind.code, kind.weight});
      add_name(rows_.kind_names, kind.name);
    }
    for (std::uint32_t t = 0; t < material_.tracks.size(); ++t) lower_track(t);
    for (std::uint32_t p = 0; p < material_.places.size(); ++p) lower_place(p);
    for (const model::Transfer& transfer : material_.transfers) lower_transfer(transfer);
    for (const model::Work& work : material_.work) lower_work(work);
    for (const model::Source& source : material_.sources) lower_source(source);
  }

 private:
  std::uint32_t condition(const std::optional<condition::Tree>& tree, tables::ReaderKind kind, std::uint32_t row,
                          std::uint8_t input = 0) const {
    return tree ? add_condition_(*tree, kind, row, input) : kNone;
  }

  void lower_track(std::uint32_t t) {
    const model::Track& track = material_.tracks[t];
    tables::TrackRow row{};
    row.length = track.length;
    row.gap = track.gap;
    row.drives = {size_of(rows_.drives), size_of(track.drives)};
    row.stops = {size_of(rows_.stops), size_of(track.stops)};
    row.ends = {size_of(rows_.ends), size_of(track.ends)};
    row.sensors = lower_sensors(track.sensors, t);
    for (const model::Drive& drive : track.drives) {
      const std::uint32_t index = size_of(rows_.drives);
      const std::uint32_t forward = condition(drive.forward, tables::ReaderKind::drive, index, 0);
      const std::uint32_t backward = condition(drive.backward, tables::ReaderKind::drive, index, 1);
      rows_.drives.push_back({drive.until, forward, backward, drive.symbol, drive.speed, drive.output});
    }
    for (const model::Stop& stop : track.stops) {
      rows_.stops.push_back({stop.at, condition(stop.condition, tables::ReaderKind::stop, size_of(rows_.stops))});
    }
    for (const model::TrackEnd& end : track.ends) {
      rows_.ends.push_back({end.to, condition(end.condition, tables::ReaderKind::end, size_of(rows_.ends))});
    }
    rows_.tracks.push_back(row);
    add_name(rows_.location_names, track.name);
  }

  void lower_place(std::uint32_t p) {
    const model::Place& place = material_.places[p];
    rows_.places.push_back({place.holds, lower_sensors(place.sensors, size_of(material_.tracks) + p)});
    add_name(rows_.location_names, place.name);
  }

  tables::Rows lower_sensors(const std::vector<model::PartSensor>& sensors, std::uint32_t location) {
    const tables::Rows rows{size_of(rows_.sensors), size_of(sensors)};
    for (const model::PartSensor& sensor : sensors) {
      rows_.sensors.push_back(
          {sensor.symbol, location, sensor.at, add_all(rows_.sensor_kinds, sensor.kinds), sensor.reads});
    }
    return rows;
  }

  static tables::Rows add_all(std::vector<std::uint32_t>& all, const std::vector<std::uint32_t>& kinds) {
    const tables::Rows rows{size_of(all), size_of(kinds)};
    all.insert(all.end(), kinds.begin(), kinds.end());
    return rows;
  }

  void lower_transfer(const model::Transfer& transfer) {
    const std::uint32_t when = condition(transfer.condition, tables::ReaderKind::transfer, size_of(rows_.transfers));
    rows_.transfers.push_back({transfer.from, transfer.to, when, transfer.once});
    add_name(rows_.transfer_names, transfer.name);
  }

  void lower_work(const model::Work& work) {
    const std::uint32_t when = add_condition_(work.condition, tables::ReaderKind::work, size_of(rows_.work), 0);
    rows_.work.push_back({work.at, when, work.from, work.to});
    add_name(rows_.work_names, work.name);
  }

  void lower_source(const model::Source& source) {
    const std::uint32_t when = condition(source.condition, tables::ReaderKind::source, size_of(rows_.sources));
    rows_.sources.push_back({source.to, add_all(rows_.source_kinds, source.kinds), source.first,
                             source.every ? lower_time(*source.every, tables_) : 0,
                             source.count.value_or(tables::kAnyNumber), when});
    add_name(rows_.source_names, source.name);
  }

  const model::Material& material_;
  const AddCondition& add_condition_;
  EngineTables& tables_;
  Material& rows_;
};

}  // namespace

void lower_material(const model::PlantModel& plant, const AddCondition& add_condition, EngineTables& tables) {
  if (plant.material.empty()) return;
  MaterialLowering(plant.material, add_condition, tables).run();
}

}  // namespace symplant::lower
