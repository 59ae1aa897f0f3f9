// Plant time from a PLC's clock: which operation it is, and reporting its restarts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "symplant/exec/plc_time.hpp"
#include "symplant/host/links.hpp"
#include "symplant/host/plant_program.hpp"
#include "symplant/host/run_options.hpp"
#include "symplant/trace/recorder.hpp"

namespace symplant::host {

/// A numeric operation that a PLC counts up, and the link that carries it.
struct PlcClockChoice {
  std::string name;
  std::uint32_t symbol;
  std::size_t link;  ///< index in the links of the run
  exec::PlcClockOptions clock;

  /// "`T_MS` (16 bits, 1 ms)".
  std::string text() const;
};

/// At most one of the members has a value. Without any, plant time follows the wall clock.
struct ChosenPlcClock {
  std::optional<PlcClockChoice> clock;
  std::string error;
  std::string warning;
};

/// The clock of `--clock plc:SYMBOL`, else that of the plant's description unless `--clock real` is given. O(symbols).
ChosenPlcClock choose_plc_clock(const PlantProgram& program, const RunOptions& options, const LinkChoices& links);

/// Plant time from a clock, whose restarts are findings. For the cycle's thread; the arguments must outlive it.
class ReportedPlcTime final : public exec::PlcTime {
 public:
  ReportedPlcTime(const PlcClockChoice& choice, const plant::Plant& plant, const Links& links,
                  trace::Recorder& recorder);

 private:
  void restarted(const plant::Plant& plant) noexcept override;

  trace::Recorder& recorder_;
  std::uint32_t symbol_;
};

}  // namespace symplant::host
