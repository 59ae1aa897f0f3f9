// The real-time cycle: links and plant, once per cycle, at absolute deadlines.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>

#include "symplant/exec/clock.hpp"
#include "symplant/exec/cycle_meter.hpp"
#include "symplant/exec/exchange.hpp"
#include "symplant/exec/plc_time.hpp"
#include "symplant/exec/stepper.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::exec {

struct CycleOptions {
  tables::Time cycle = 10 * tables::kMillisecond;  ///< from deadline to deadline, > 0
  tables::Time until = tables::kNever;  ///< plant time of the last cycle, which may be shorter; see run_cycles()
  bool ends_when_over = false;          ///< the run ends before `until` when the stepper is over
  std::int64_t max_catch_up = 10;       ///< cycles run at once after a delay; the time of the others slips
  tables::Time spin = 0;  ///< how long before a deadline the thread stops sleeping and polls the clock; up to `cycle`
};

/// Gets a report when a standstill of the plant is over. Called in the cycle, so it must be bounded, without heap, lock
/// or system call.
class StandstillWatch {
 public:
  /// `lost`: the plant time that was not caught up, ns.
  virtual void stood_still(tables::Time lost) noexcept = 0;

 protected:
  ~StandstillWatch() = default;
};

/// The parts of a real-time run next to the plant and its links. They must outlive the run.
struct CycleParts {
  Clock& clock;
  CycleMeter& meter;              ///< gets the results; any thread may read it meanwhile
  const std::atomic<bool>& stop;  ///< ends the run within 0.1 s; any thread or a signal handler may set it
  engine::Observer* observer = nullptr;
  Stepper* stepper = nullptr;   ///< advances the plant instead of run_cycles()
  PlcTime* plc_time = nullptr;  ///< decides plant time instead of the clock
  StandstillWatch* standstill = nullptr;
};

/// The shortest time for which a plant waits for a PLC before `CycleOptions::until` may end the run.
inline constexpr tables::Time kPatience = 5 * tables::kSecond;

/// Runs the plant in real time from its current time until `parts.stop` or `options.until`.
///
/// First it runs the plant's instant at now() and writes the events to every link. Then, in each cycle, at plant time
/// T: it reads the operations from every link, advances the plant to T, writes the events to every link, and calls
/// forget_changed_events(). T grows by `options.cycle`, in step with the clock. A late cycle runs at once, for its own
/// T, so the plant catches up in order. If more than `max_catch_up` cycles are due in addition to the current one, the
/// time of the others slips.
///
/// While a link freezes the plant, cycles continue with the links only; plant time does not run and is not caught up.
/// `options.until` ends such a run, too. The plant waits while a link freezes it, or while `plc_time` is without its
/// PLC. The run ends when the plant has waited without a break for the plant time that is left until `options.until`,
/// and for at least kPatience.
///
/// With `plc_time` the clock only decides when cycles run. Plant time is that of `plc_time`, which `options.until`
/// limits. Deadlines that have passed are skipped: nothing is caught up, and nothing slips.
///
/// With a stepper and without `options.until` the run ends with the cycle in which stepper->over() becomes true. No
/// heap and no locks; the only system calls are those of the clock. Everything except the links' leave() is guarded
/// (guard/guard.hpp), so that a run under the trap verifies this.
void run_cycles(plant::Plant& plant, std::span<Exchange* const> links, const CycleOptions& options,
                const CycleParts& parts) noexcept;

}  // namespace symplant::exec
