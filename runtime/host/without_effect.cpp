// Warns of options without effect.
#include "symplant/host/without_effect.hpp"

#include <ostream>
#include <string>
#include <utility>

#include "symplant/trace/output_file.hpp"

namespace symplant::host {

void report_without_effect(const RunOptions& options, const RunKind& run, std::ostream& err) {
  const std::pair<const char*, bool> of_real_time[] = {{"--cycle", options.cycle_given && !options.rt_check},
                                                       {"--on-loss", options.on_loss.has_value()},
                                                       {"--late", options.late_given},
                                                       {"--priority", options.real_time.priority.has_value()},
                                                       {"--cpu", options.real_time.cpu.has_value()},
                                                       {"--lock-memory", options.real_time.lock_memory},
                                                       {"--stay-awake", options.real_time.stay_awake},
                                                       {"--spin", options.spin != 0}};
  std::string names;
  std::size_t count = 0;
  for (const auto& [name, given] : of_real_time) {
    if (run.real || !given) continue;
    names += (count++ == 0 ? "`" : ", `") + std::string(name) + "`";
  }
  if (count != 0) {
    err << "warning: " << names << (count == 1 ? " has" : " have")
        << " no effect in virtual time; to run in real time, add `--clock real`\n";
  }
  if (run.by_plc && options.late_given) {
    err << "warning: `--late` has no effect, since plant time follows the PLC's clock; to follow the wall clock, add "
           "`--clock real`\n";
  }
  if (!run.programmed && (options.scan || options.scan_delay)) {
    err << "warning: `" << (options.scan ? "--scan" : "--scan-delay")
        << "` has no effect without a program; add one with `--program`\n";
  }
  if (run.real && !run.linked && options.on_loss) {
    err << "warning: `--on-loss` has no effect without a link that can be lost; add one with `--link`\n";
  }
  if (options.trace_limit != trace::kNoLimit && options.trace.empty() && options.vcd.empty()) {
    err << "warning: `--trace-limit` has no effect without `--trace` or `--vcd`; add one of them\n";
  }
}

}  // namespace symplant::host
