// SP417 end-without-sensor: one end position lacks its sensor where sibling devices have two.
#include <fmt/format.h>

#include <algorithm>

#include "check/rules.hpp"
#include "check/spelling/odd_devices.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kEndWithoutSensorPage =
    R"(Under a naming rule of your own, a device has sensors of one end of its motion only, and nearly all devices whose names differ only in
digits have sensors of both ends. Under the built-in rule SP414 reports this.

**What the model loses.** The PLC waits for the missing sensor in vain: nothing in the plant sets it.

**How to fix it.** Add the row, or spell the end as the other devices do. If the device has no such sensor, ignore the finding.
)";

/// A task without the number of its sensor: `RET` of `RET2`.
std::string_view end_of(std::string_view task) {
  while (!task.empty() && (text::is_digit(task.back()) || task.back() == '_')) task.remove_suffix(1);
  return task;
}

bool has_event_of(const model::PlantModel& plant, const model::Unit& unit, std::string_view end) {
  return std::any_of(unit.events.begin(), unit.events.end(), [&](std::uint32_t event) {
    return text::equal_ignoring_case(end_of(plant.symbols[event].reading.task), end);
  });
}

void check_end_without_sensor(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (plant.pairing == nullptr) return;
  for (const OddDevice& odd : odd_devices(subject)) {
    if (odd.device >= plant.units.size()) continue;
    const model::Unit& unit = plant.units[odd.device];
    if (unit.events.empty()) continue;
    for (const Lacking& lacking : odd.lacks) {
      const std::string_view end = end_of(lacking.others->reading.task);
      if (lacking.others->direction != tables::Direction::event || has_event_of(plant, unit, end)) continue;
      const diag::Subject sensor = missing(plant, unit.path, tables::Direction::event, end);
      diagnostics.add(
          rule.info, about(unit).explaining(sensor),
          fmt::format("`{}` has no sensor of `{}`: {} of {} devices named like it have one; add the row, or "
                      "spell it as they do",
                      unit.path, end, lacking.having, odd.of),
          location_of(plant, plant.symbols[unit.events.front()]),
          {{location_of(plant, *lacking.others), "one that has it"}});
      break;
    }
  }
}

}  // namespace

const Rule kEndWithoutSensor{
    {"SP417", "end-without-sensor", diag::Severity::warning,
     "one end position lacks its sensor where sibling devices have two", kEndWithoutSensorPage, diag::Rank::siblings},
    check_end_without_sensor};

}  // namespace symplant::check
