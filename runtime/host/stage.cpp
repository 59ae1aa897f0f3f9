// A plant ready to run, with everything but its links.
#include "symplant/host/stage.hpp"

namespace symplant::host {
namespace {

/// In real time a slow disk may delay the draining thread.
constexpr std::size_t kRealTimeRecords = std::size_t{1} << 16;

trace::Recorder::Detail detail_of(const RunOptions& options) {
  return counts_utilization(options) ? trace::Recorder::Detail::motions : trace::Recorder::Detail::changes;
}

/// In real time all memory is populated before the first cycle. Without a file of changes the records only serve the
/// texts of findings, for which a change of each symbol and unit suffices.
std::size_t capacity(const tables::PlantTables& tables, const RunOptions& options, bool real_time) {
  const trace::Recorder::Detail detail = detail_of(options);
  const std::size_t least = options.panel ? kRealTimeRecords : 0;  // one step of a panel may have several instants
  if (!real_time) return std::max(least, trace::Recorder::enough_for_a_loop(tables, detail));
  const std::size_t enough = trace::Recorder::enough_for_an_instant(tables, detail);
  return std::max(kRealTimeRecords, records_changes(options) || counts_utilization(options)
                                        ? 2 * enough
                                        : tables.symbols.size() + tables.units.size());
}

}  // namespace

Stage::Stage(const PlantProgram& program, const RunOptions& options, const trace::PlantNames& names,
             const scenario::Scenario* scenario, bool real_time, const RunStreams& streams)
    : plant(program.tables, program.behaviours),
      recorder(program.tables, capacity(program.tables, options, real_time), detail_of(options)),
      history(names),
      explainer(names, program.behaviours),
      report(explainer, history, real_time ? nullptr : &plant, scenario, options.scenario, program.ignored,
             streams.console),
      outputs(names, options, recorder, history, report, streams.out) {
  plant.reset(options.seed, real_time ? options.cycle : 0);
  recorder.attach(plant);
  if (scenario != nullptr) player.emplace(*scenario, plant, recorder);
  outputs.write_acts([scenario, &names](std::uint64_t act) { return act_of(*scenario, act, names); });
}

void Stage::start_fault(std::uint32_t number, tables::Time at) {
  fault.emplace(number, at, plant, recorder);
  stepper(nullptr);
}

bool Stage::resume(const trace::Snapshot& snapshot) {
  if (!plant.restore(snapshot.block)) return false;
  plant.show_outputs();
  recorder.take_over();
  history.load(plant);
  if (player) player->begin_again();
  return true;
}

}  // namespace symplant::host
