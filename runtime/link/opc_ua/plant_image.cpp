// What clients of the server see of the plant in addition to its symbols.
#include "symplant/link/opc_ua/plant_image.hpp"

#include <algorithm>
#include <bit>
#include <chrono>

#include "symplant/link/image/words.hpp"

namespace symplant::link::opc_ua {

namespace {

/// Malfunctions that are active at a time: all written ones, and the ordinary ones.
std::size_t most_active(const tables::PlantTables& tables) noexcept {
  return tables.malfunctions.rows.size() + tables::kMostOrdinaryMalfunctions;
}

std::uint64_t wall_time() noexcept {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(now).count());
}

}  // namespace

PlantWords::PlantWords(const tables::PlantTables& tables, const image::Map& map) noexcept
    : outputs(kFrozen + 1),
      units(outputs + tables.values.outputs),
      decided(units + tables.units.size()),
      active(decided + image::bit_words(static_cast<std::uint32_t>(map.points.size()))),
      end(active + image::bit_words(tables.malfunctions.size())) {}

PlantImage::PlantImage(const tables::PlantTables& tables, const image::Map& map)
    : tables_(tables),
      at_(tables, map),
      first_event_(tables.symbols.size(), tables::kNone),
      next_event_(map.points.size(), tables::kNone),
      words_(std::vector<std::uint64_t>(at_.end, 0)) {
  active_.reserve(most_active(tables));
  std::array<std::vector<std::uint32_t>, kPlanes> last;  // by plane and position: its last point
  for (std::size_t plane = 0; plane < kPlanes; ++plane) last[plane].assign(map.sizes[plane], tables::kNone);
  for (std::uint32_t i = 0; i < map.points.size(); ++i) {
    const image::Point& point = map.points[i];
    if (!is_event(point.plane)) continue;
    std::uint32_t& before = last[static_cast<std::size_t>(point.plane)][point.position];
    next_event_[i] = before;
    before = i;
  }
  for (const image::Point& point : map.points) {
    if (is_event(point.plane)) {
      first_event_[point.symbol] = last[static_cast<std::size_t>(point.plane)][point.position];
    }
  }
}

void PlantImage::set(std::size_t word, std::uint64_t value) noexcept {
  if (words_.words()[word] == value) return;
  words_.words()[word] = value;
  words_.touch(word);
}

void PlantImage::set_bit(std::size_t first, std::uint32_t bit, bool on) noexcept {
  const std::size_t word = first + bit / image::kBitsPerWord;
  const std::uint64_t mask = std::uint64_t{1} << (bit % image::kBitsPerWord);
  set(word, on ? words_.words()[word] | mask : words_.words()[word] & ~mask);
}

void PlantImage::write_units(const plant::Plant& plant) noexcept {
  const auto units = static_cast<std::uint32_t>(tables_.units.size());
  for (std::uint32_t i = 0; i < std::min(units, kUnitsOfCycle); ++i) {
    const plant::UnitView view = plant.unit(next_unit_);
    const auto progress = static_cast<std::uint16_t>(view.progress * 1000);
    set(at_.units + next_unit_, pack(UnitState{view.state, view.target, view.moving, progress}));
    if (++next_unit_ == units) next_unit_ = 0;
  }
}

void PlantImage::write_outputs(const plant::Plant& plant) noexcept {
  const std::uint32_t outputs = tables_.values.outputs;
  for (std::uint32_t i = 0; i < std::min(outputs, kOutputsOfCycle); ++i) {
    set(at_.outputs + next_output_, std::bit_cast<std::uint64_t>(plant.output(next_output_)));
    if (++next_output_ == outputs) next_output_ = 0;
  }
}

void PlantImage::write_malfunctions(const plant::Plant& plant) noexcept {
  const auto active = plant.active_malfunctions();
  const auto same = [](const engine::ActiveMalfunction& a, const engine::ActiveMalfunction& b) {
    return a.number == b.number;
  };
  if (std::equal(active.begin(), active.end(), active_.begin(), active_.end(), same)) return;
  const tables::MalfunctionNumbers numbers(tables_);
  const auto mark = [&](const engine::ActiveMalfunction& malfunction, bool on) {
    if (numbers.is_written(malfunction.number)) set_bit(at_.active, malfunction.number, on);
    numbers.for_symbols(malfunction.number, [&](std::uint32_t symbol) {
      for (std::uint32_t i = first_event_[symbol]; i != tables::kNone; i = next_event_[i]) set_bit(at_.decided, i, on);
    });
  };
  for (const engine::ActiveMalfunction& before : active_) mark(before, false);
  for (const engine::ActiveMalfunction& now : active) mark(now, true);
  active_.assign(active.begin(),
                 active.begin() + static_cast<std::ptrdiff_t>(std::min(active.size(), active_.capacity())));
}

void PlantImage::write(const plant::Plant& plant, const exec::CycleStatus& status) noexcept {
  set(PlantWords::kCycles, status.cycles + 1);  // this one included
  set(PlantWords::kTime, wall_time());
  set(PlantWords::kPlantTime, static_cast<std::uint64_t>(plant.now()));
  set(PlantWords::kFrozen, status.frozen ? 1 : 0);
  write_units(plant);
  write_outputs(plant);
  write_malfunctions(plant);
  words_.publish();
}

}  // namespace symplant::link::opc_ua
