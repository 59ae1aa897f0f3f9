// What a run came to, in numbers, as JSON.
#include "symplant/host/stats.hpp"

#include <fmt/format.h>

#include "symplant/trace/value_text.hpp"

namespace symplant::host {

std::string stats_text(const StatsInput& input) {
  std::string text =
      fmt::format(R"({{"symplant-stats":1,"plant":{},"model_hash":"{:016x}","seed":{},"plant_time":{},"wall_time":{},)"
                  R"("instants":{},"changes":{})",
                  trace::json_string(input.plant.tables().name), input.plant.model_hash(), input.seed,
                  input.plant.now(), input.wall, input.outputs.instants(), input.outputs.changes());
  text += ",\"findings\":{";
  for (int kind = 0; kind < core::kAllFindingKinds; ++kind) {
    const auto which = static_cast<core::FindingKind>(kind);
    text += fmt::format(R"({}"{}":{})", kind == 0 ? "" : ",", trace::finding_name(which), input.report.count(which));
  }
  text += "}";
  if (input.verdict) {
    text += fmt::format(R"(,"expectations":{{"held":{},"failed":{},"unreached":{}}})", input.verdict->held,
                        input.verdict->failed, input.verdict->unreached);
  }
  const std::size_t requirements = input.plant.tables().requirements.size();
  const std::size_t violated = input.report.requirements_violated();
  text += fmt::format(R"(,"requirements":{{"held":{},"violated":{}}})", requirements - violated, violated);
  if (input.real_time) {
    const exec::CycleStatistics& cycles = *input.real_time;
    text += fmt::format(R"(,"cycles":{},"overruns":{},"slipped":{},"max_lateness":{})", cycles.cycles, cycles.overruns,
                        cycles.slipped, cycles.max_lateness);
  }
  return text + "}\n";
}

}  // namespace symplant::host
