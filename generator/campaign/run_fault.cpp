// Runs one fault of a campaign.
#include "campaign/run_fault.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string_view>

#include "symplant/host/exit_codes.hpp"
#include "symplant/tables/duration.hpp"
#include "text/shell_word.hpp"

namespace symplant::campaign {
Result result_of(const Campaign& campaign, const Planned& planned) {
  const Fault& fault = campaign.faults[planned.fault];
  Result result;
  result.item = fault.item;
  result.more = fault.more;
  result.mode = mode_words(fault);
  result.phase = planned.phase;
  result.at = planned.at;
  result.command = fmt::format("{} --until {} --fault {}", campaign.command,
                               tables::duration_text(campaign.base.log.end), text::shell_word(fault.malfunction));
  if (planned.at != 0) result.command += fmt::format(" --fault-at {}", tables::duration_text(planned.at));
  if (planned.needed) return result;
  result.is = Class::no_effect;
  result.reaction = "not run: the base case shows the same, so the fault does not matter in it";
  result.end = "as without the fault";
  result.ran = false;
  return result;
}

namespace {

/// The first step of the base case that fails, by the messages of a run: `base.json:7: error: ...`.
std::string failed_step(const std::string& messages) {
  constexpr std::string_view kError = ": error: ";
  std::istringstream lines(messages);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t error = line.find(kError);
    if (error == line.npos) continue;
    const std::string where = line.substr(0, error);
    return where.substr(where.find_last_of("/\\") + 1) + ": " + line.substr(error + kError.size());
  }
  return "";
}

/// When an operation changes after a run that has stopped; nothing: it stays so for three longest pauses more, as long
/// as a move can take that is three times slower.
std::optional<tables::Time> goes_on(const Campaign& campaign, const Planned& planned, const RunLog& log) {
  constexpr int kLonger = 3;
  const std::string& malfunction = campaign.faults[planned.fault].malfunction;
  RunLog longer;
  run_logged(campaign.setup, campaign.plant, malfunction, planned.at, log.end + kLonger * campaign.base.pause, longer);
  const auto next = std::find_if(longer.symbols.begin(), longer.symbols.end(), [&](const Change& change) {
    return change.time > log.end && campaign.base.operations[change.of];
  });
  return next == longer.symbols.end() ? std::nullopt : std::optional(next->time);
}

}  // namespace

Result run_fault(const Campaign& campaign, const Planned& planned) {
  Result result = result_of(campaign, planned);
  if (!planned.needed) return result;
  const Fault& fault = campaign.faults[planned.fault];
  RunLog log;
  const Ended ended =
      run_logged(campaign.setup, campaign.plant, fault.malfunction, planned.at, campaign.base.log.end, log);
  if (ended.code != host::kGood && ended.code != host::kFindings) {
    result.reaction = without_severity(ended.messages);
    return result;
  }
  judge(campaign.base, campaign.facts, log, fault, result);
  if (result.is == Class::stopped) {
    if (const auto next = goes_on(campaign, planned, log)) {
      result = result_of(campaign, planned);
      judge(campaign.base, campaign.facts, log, fault, result, next);
    }
  }
  if (result.is != Class::no_effect) result.failed_step = failed_step(ended.messages);
  return result;
}

}  // namespace symplant::campaign
