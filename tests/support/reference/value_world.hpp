// What changes in the values and signals of the reference's plant.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace symplant::reference {

struct ValueWorld {
  std::vector<double> outputs;
  bool stored = false;         ///< the inputs were stored at the last computation
  std::vector<double> inputs;  ///< as stored, in the order of ValueRules::inputs; empty if not stored
  std::vector<double> ring;    ///< `delay`: stored inputs from the oldest to the newest
  std::vector<double> states;  ///< `linear`
  std::optional<double> last;  ///< u of `derivative`, `of` of `pid`
  double integral = 0;         ///< i of `pid`
  std::uint32_t draws = 0;
  bool frozen = false;
  /// A parameter that a malfunction holds: the number that it has afterwards.
  std::optional<double> without_malfunctions;
  bool was_set = false;           ///< since the last instant
  bool not_finite = false;        ///< in the last computation, or in a jump since
  bool shown_not_finite = false;  ///< at the end of the last instant
  std::vector<double> shown;      ///< the outputs at the end of the last instant
  std::vector<bool> truths;       ///< of `changes`, in the last round
  std::vector<double> traced;     ///< what the trace has of ValueRules::traced; empty: nothing so far
};

struct SignalWorld {
  std::uint32_t draws = 0;
};

}  // namespace symplant::reference
