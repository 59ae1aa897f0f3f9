// Reads the counter of a PlcClock from the plant.
#include "symplant/exec/plc_time.hpp"

#include <utility>

namespace symplant::exec {

PlcTime::PlcTime(const PlcClockOptions& options, const plant::Plant& plant, std::uint32_t slot,
                 const Exchange& link) noexcept
    : clock_(options, plant.now()), link_(link), slot_(slot), value_(plant.written_operation_value(slot)) {}

tables::Time PlcTime::next(const plant::Plant& plant, std::int64_t cycles) noexcept {
  if (cycles > 1) clock_.step(cycles - 1);
  follow_link(plant);
  const std::uint64_t value = plant.written_operation_value(slot_);
  if (std::exchange(value_, value) != value && link_.state() == LinkState::live && clock_.arrive(value)) {
    restarted(plant);
  }
  return clock_.step();
}

void PlcTime::hold(const plant::Plant& plant) noexcept {
  follow_link(plant);
  clock_.hold();
  value_ = plant.written_operation_value(slot_);
}

void PlcTime::follow_link(const plant::Plant& plant) noexcept {
  const LinkState state = link_.state();
  if (state == LinkState::lost) was_lost_ = true;
  if (state != LinkState::live || !std::exchange(was_lost_, false)) return;
  if (clock_.restart()) restarted(plant);
}

}  // namespace symplant::exec
