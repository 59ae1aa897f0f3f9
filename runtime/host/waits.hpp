// Reports during a run what its plant waits for.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symplant/exec/cycle_meter.hpp"
#include "symplant/host/line_limit.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::host {

/// A link, as messages to the user describe it.
struct WaitedLink {
  std::string name;
  std::string absence = {};  ///< why no PLC is there, and what to check; empty: `no PLC` is not to be reported
  bool freezes = false;      ///< the plant is frozen while the link is not live
  bool is_clock = false;     ///< it carries the PLC's clock
};

/// Reports each once: a link without a PLC from 5 s on; a plant that a link freezes, and when it goes on; a clock of
/// the PLC that has not counted for 3 s. Pure; used by one thread at a time.
class Waits {
 public:
  /// `clock`: name of the operation that is the PLC's clock; empty: plant time follows the wall clock.
  Waits(std::vector<WaitedLink> links, std::string clock);

  /// The lines that are due `now` after the start of the cycle, by the state of the last cycle.
  std::vector<std::string> look(tables::Time now, const exec::CycleMeter& meter);

 private:
  void look_for_plcs(tables::Time now, const exec::CycleMeter& meter, std::vector<std::string>& lines);
  void look_at_freeze(tables::Time now, const exec::CycleMeter& meter, std::vector<std::string>& lines);
  void look_at_clock(tables::Time now, const exec::CycleMeter& meter, std::vector<std::string>& lines);
  bool clock_is_live(const exec::CycleMeter& meter) const;

  std::vector<WaitedLink> links_;
  std::string clock_;
  std::vector<bool> missed_;  ///< by link: its PLC has been reported as missing
  bool frozen_ = false;
  bool shows_freeze_ = false;  ///< whether the current freeze was reported, so that its end is reported, too
  tables::Time frozen_at_ = 0;
  LineLimit freezes_;
  std::uint64_t values_ = 0;     ///< of the clock
  tables::Time counted_at_ = 0;  ///< when the clock counted last, or its link became live
  bool stopped_ = false;         ///< the clock has been reported since then
};

}  // namespace symplant::host
