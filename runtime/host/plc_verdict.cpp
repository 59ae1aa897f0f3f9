// The verdict on the PLCs of a run in real time: whether they connected, and whether plant time ran.
#include "symplant/host/plc_verdict.hpp"

#include <fmt/format.h>

#include "symplant/host/words.hpp"
#include "symplant/tables/finding.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::host {
namespace {

using exec::LinkState;

/// The first link that keeps the plant frozen: "URL is lost"; empty if there is none.
std::string freezing_link(const Links& links) {
  for (const OpenLink& open : links) {
    if (open.link->freezes_plant()) {
      return fmt::format("link {} is {}, and its `plant-on-loss` is `freeze`", open.text(),
                         state_name(open.link->state()));
    }
  }
  return "";
}

/// Why plant time waits for the PLC's clock; empty if its PLC is there.
std::string clock_wait(const Links& links, const PlcClockChoice& clock, const exec::CycleStatistics& cycles) {
  const OpenLink& open = links[clock.link];
  if (cycles.plc_clock && !cycles.plc_clock->has_counted()) {
    return fmt::format("the PLC's clock `{}` has not counted; check whether the PLC's program runs and counts it up",
                       shown(clock.name));
  }
  if (open.link->state() == LinkState::live) return "";
  return fmt::format("link {}, which carries the PLC's clock `{}`, is {}", open.text(), shown(clock.name),
                     state_name(open.link->state()));
}

}  // namespace

PlcVerdict judge_plcs(Stage& stage, const Links& links, const PlcClockChoice* clock,
                      const exec::CycleStatistics& cycles, bool gave_up) {
  PlcVerdict verdict;
  const tables::Time now = stage.plant.now();
  for (std::size_t i = 0; i < links.size(); ++i) {
    const OpenLink& open = links[i];
    if (open.link->state() != LinkState::waiting) continue;
    stage.recorder.raise(now, tables::FindingKind::no_plc, static_cast<std::uint32_t>(i));
    const link::LinkStatus status = open.link->status();
    if (status.is_client && !status.reached && verdict.unreached.empty()) {
      verdict.unreached = fmt::format("link {} never had a connection to its PLC, {}", open.text(), open.absence());
    }
  }
  std::string reason = gave_up ? freezing_link(links) : "";
  const bool never_ran = clock != nullptr && cycles.plc_clock && !cycles.plc_clock->has_counted();
  if (reason.empty() && clock != nullptr && (gave_up || never_ran)) reason = clock_wait(links, *clock, cycles);
  if (!reason.empty()) verdict.stalled = fmt::format("plant time waited at {}, since {}", trace::seconds(now), reason);
  return verdict;
}

}  // namespace symplant::host
