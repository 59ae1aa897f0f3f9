// Reads one entry of `programs` in plant.json.
#include <nlohmann/json.hpp>

#include "description/json_entry.hpp"

namespace symplant::description {

ProgramDescription program_entry(const nlohmann::json& entry, const Pointer& here, ShapeFaults& faults) {
  ProgramDescription program;
  program.file = text_or_empty(entry, "file");
  program.controller = text_or_empty(entry, "controller");
  const auto above_zero = [&](const char* key) {
    const auto time = time_member(entry, key, here, faults);
    if (time && *time == 0) faults.add(here / key, "the time is 0; write a longer one, such as `10ms`");
    return time.value_or(0);
  };
  program.period = above_zero("period");
  program.delay = above_zero("delay");
  if (program.period != 0 && program.delay > program.period) {
    faults.add(here / "delay", "the delay is longer than the period; write at most the period");
  }
  if (text_or_empty(entry, "on-loss") == "zero") program.on_loss = link::OnLoss::zero;
  program.ignore = texts_member(entry, "ignore");
  return program;
}

}  // namespace symplant::description
