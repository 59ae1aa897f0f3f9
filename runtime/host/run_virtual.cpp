// A run in virtual time.
#include "symplant/host/run_virtual.hpp"

#include <fmt/format.h>

#include "symplant/host/signals.hpp"
#include "symplant/host/words.hpp"

namespace symplant::host {
namespace {

/// Where virtual time without `--until` ends at the latest.
constexpr core::Time kLongest = 3600 * core::kSecond;

}  // namespace

void run_virtual(core::Plant& plant, const RunOptions& options, Outputs& outputs, std::ostream& out) {
  const core::Time end = options.until.value_or(kLongest);
  while (!stop_requested().load(std::memory_order_relaxed)) {
    const core::Time due = plant.next_due();
    if (due > end) {
      const bool nothing_left = due == core::kNever;
      if (options.until || !nothing_left) plant.advance_to(end, outputs.observer());
      outputs.drain();
      if (options.until) {
        out << fmt::format("ended at {}, as asked\n", seconds(end));
      } else if (nothing_left) {
        out << fmt::format("ended at {}: nothing more is due; --link lets a PLC move it\n", seconds(plant.now()));
      } else {
        out << fmt::format("ended at {} of plant time: the plant would go on for ever; --until says how long\n",
                           seconds(end));
      }
      return;
    }
    plant.advance_to(due, outputs.observer());
    outputs.drain();
  }
  out << fmt::format("ended at {} by a signal\n", seconds(plant.now()));
}

}  // namespace symplant::host
