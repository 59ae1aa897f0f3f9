// Runs a plant in virtual time.
#include "symplant/host/run_virtual.hpp"

#include <fmt/format.h>

#include "symplant/host/signals.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::host {
namespace {

using trace::seconds;

/// The latest end of a run with neither `--until` nor a scenario.
constexpr tables::Time kLongest = 3600 * tables::kSecond;

void advance(Stage& stage, tables::Time time) {
  stage.advance_to(time);
  stage.outputs.drain();
}

}  // namespace

void run_virtual(Stage& stage, const RunOptions& options, std::ostream& out) {
  const bool by_scenario = stage.player && !options.until;
  const tables::Time end = by_scenario ? options.limit.value_or(tables::kNever) : options.until.value_or(kLongest);
  while (!stop_requested().load(std::memory_order_relaxed)) {
    if (stage.programs && stage.programs->failed()) {
      out << fmt::format("ended at {}: a program failed\n", seconds(stage.plant.now()));
      return;
    }
    if (by_scenario && stage.player->over()) {
      out << fmt::format("ended at {}: the scenario is over\n", seconds(stage.plant.now()));
      return;
    }
    const tables::Time due = stage.next_due();
    if (due > end || due == tables::kNever) {
      const bool nothing_left = due == tables::kNever;
      const bool limited = by_scenario && options.limit;
      if (options.until || limited || !nothing_left) advance(stage, end);
      if (limited) {
        out << fmt::format("ended at {}: the limit is reached\n", seconds(end));
      } else if (options.until) {
        out << fmt::format("ended at {}: --until is reached\n", seconds(end));
      } else if (nothing_left) {
        out << fmt::format("ended at {}: nothing more will happen; drive the plant with --link or --scenario\n",
                           seconds(stage.plant.now()));
      } else {
        out << fmt::format("ended at {} of plant time: the plant would run forever; set the end with --until\n",
                           seconds(end));
      }
      return;
    }
    advance(stage, due);
  }
  out << fmt::format("ended at {} by a signal\n", seconds(stage.plant.now()));
}

}  // namespace symplant::host
