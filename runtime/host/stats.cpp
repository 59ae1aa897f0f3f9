// Statistics of a run.
#include "symplant/host/stats.hpp"

#include <fmt/format.h>

#include "symplant/host/words.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/trace/utilization_text.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::host {
namespace {

std::string durations_text(const char* name, const exec::Durations& durations) {
  return fmt::format(R"(,"{}":{{"p50":{},"p99":{},"p99.9":{},"max":{}}})", name, durations.p50, durations.p99,
                     durations.p999, durations.max);
}

std::string real_time_text(const RealRun& run) {
  const exec::CycleStatistics& cycles = run.cycles;
  std::string text = fmt::format(R"(,"cycles":{},"overruns":{},"slipped":{},"frozen":{})", cycles.cycles,
                                 cycles.overruns, cycles.slipped, cycles.frozen);
  text += durations_text("lateness", cycles.lateness) + durations_text("work", cycles.work) +
          durations_text("jitter", cycles.jitter);
  text += fmt::format(R"(,"page_faults":{{"minor":{},"major":{}}},"preempted":{})", run.faults.minor, run.faults.major,
                      run.faults.preempted);
  text += fmt::format(R"(,"rt":"{}","refused":[)", !run.asked ? "off" : run.refused.empty() ? "on" : "degraded");
  for (const exec::Refusal& refusal : run.refused) {
    text += (&refusal == run.refused.data() ? "\"" : ",\"") + refusal.option + "\"";
  }
  return text + "]";
}

std::string clock_text(const PlcClockChoice& clock, const exec::PlcClockReading& reading) {
  return fmt::format(
      R"(,"plc_clock":{{"of":{},"bits":{},"unit":{},"values":{},"phase_error":{{"last":{},"max":{}}},"waits":{},"restarts":{}}})",
      trace::json_string(clock.name), clock.clock.bits, clock.clock.unit, reading.values, reading.phase_error,
      reading.largest_phase_error, reading.waits, reading.restarts);
}

std::string links_text(const Links& links) {
  std::string text = ",\"links\":[";
  for (const OpenLink& open : links) {
    const link::LinkStatus status = open.link->status();
    text += fmt::format(
        R"({}{{"link":{},"state":"{}","losses":{},"requests":{},"exceptions":{},"writes_to_gaps":{},"connections":{},"crowded_out":{}{}}})",
        &open == links.data() ? "" : ",", trace::json_string(open.text()), state_name(open.link->state()),
        status.losses, status.requests, status.exceptions, status.writes_to_gaps, status.connections,
        status.crowded_out,
        !status.is_client ? ""
        : status.armed    ? R"(,"armed":true)"
                          : R"(,"armed":false)");
  }
  return text + "]";
}

/// The parts made, gone and present, by kind; empty without material.
std::string parts_text(const plant::Plant& plant) {
  const tables::MaterialTables& material = plant.tables().material;
  if (material.empty()) return "";
  std::string text;
  const auto names = tables::split_names(material.kind_names);
  for (std::uint32_t k = 0; k < material.kinds.size(); ++k) {
    text += fmt::format(R"({}{}:{{"made":{},"gone":{},"present":{}}})", text.empty() ? "" : ",",
                        trace::json_string(names[k]), plant.parts_made(k), plant.parts_gone(k), plant.parts_present(k));
  }
  return ",\"parts\":{" + text + "}";
}

/// The least, the greatest and the last number of each value; empty without values.
std::string values_text(const plant::Plant& plant, const trace::PlantNames& names) {
  const tables::ValueTables& values = plant.tables().values;
  std::string text;
  for (std::uint32_t o = 0; o < values.outputs; ++o) {
    const engine::OutputRange range = plant.output_range(o);
    text += fmt::format(R"({}{}:{{"unit":{},"least":{},"greatest":{},"last":{}}})", text.empty() ? "" : ",",
                        trace::json_string(names.output(o)), trace::json_string(names.unit_of_value(names.value_of(o))),
                        range.least, range.greatest, plant.output(o));
  }
  return text.empty() ? "" : ",\"values\":{" + text + "}";
}

std::string stats_json(const StatsInput& input) {
  std::string text =
      fmt::format(R"({{"symplant-stats":1,"plant":{},"model_hash":"{:016x}","seed":{},"plant_time":{},"wall_time":{},)"
                  R"("instants":{},"changes":{})",
                  trace::json_string(input.plant.tables().name), input.plant.model_hash(), input.seed,
                  input.plant.now(), input.wall, input.outputs.instants(), input.outputs.changes());
  text += ",\"findings\":{";
  for (int kind = 0; kind < tables::kAllFindingKinds; ++kind) {
    const auto which = static_cast<tables::FindingKind>(kind);
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
  text += parts_text(input.plant) + values_text(input.plant, input.names);
  if (const trace::Utilization* utilization = input.outputs.utilization()) {
    text += ",\"utilization\":" + trace::utilization_json(*utilization, input.plant.now());
  }
  if (input.real_time) text += real_time_text(*input.real_time);
  if (input.real_time && input.clock != nullptr && input.real_time->cycles.plc_clock) {
    text += clock_text(*input.clock, *input.real_time->cycles.plc_clock);
  }
  if (!input.links.empty()) text += links_text(input.links);
  if (!input.answers.empty()) text += ",\"why\":" + answers_json(input.answers, input.names);
  return text + "}\n";
}

}  // namespace

std::string stats_text(const std::string& path, const StatsInput& input) {
  const trace::Utilization* const utilization = input.outputs.utilization();
  return path.ends_with(".csv") && utilization != nullptr ? trace::utilization_csv(*utilization, input.plant.now())
                                                          : stats_json(input);
}

}  // namespace symplant::host
