// A plant, a recording as text, and what an observer sees in it as lines.
#pragma once

#include <sstream>
#include <string>

#include "../compare/compare_support.hpp"
#include "observe/play.hpp"
#include "support/described_plant.hpp"

namespace symplant::test {

inline const std::vector<std::string> kClamp = {"L_P_CL_I_OPEN", "L_P_CL_I_CLOSED", "L_P_CL_O_OPEN", "L_P_CL_O_CLOSED"};
inline constexpr const char* kBistable = R"("devices": {"L_P_CL": {"actuation": "bistable"}})";

inline std::string ms(tables::Time time) {
  return time == observe::kUnknown ? "-" : std::to_string(time / tables::kMillisecond);
}

/// `CL: OPEN->CLOSED #1 cause 10 left 12 arrived 20`: the unit without `L_P_`, the index of its transition. A spring's
/// return has the transition `spring`.
inline std::string text_of(const model::PlantModel& plant, const observe::Move& move) {
  const model::Unit& unit = plant.units[move.unit];
  const auto state = [&](std::uint32_t s) { return s == observe::kNone ? std::string("?") : unit.states[s].name; };
  std::string path(unit.path);
  if (path.starts_with("L_P_")) path = path.substr(4);
  std::string text = path + ": " + state(move.from) + "->" + state(move.to);
  if (move.transition != observe::kNone) text += " #" + std::to_string(move.transition);
  if (move.spring_return) text += " spring";
  text += " cause " + ms(move.cause) + " left " + ms(move.left) + " arrived " + ms(move.arrived);
  if (move.stopped != 0) text += " stopped " + ms(move.stopped);
  if (move.turned) text += " turned";
  return text;
}

class Observed {
 public:
  Observed(const std::vector<std::string>& names, const std::string& members) : plant_(bits(names), members) {}

  /// The moves of a recording in which every symbol is off at first; `header` as in trace_text().
  std::string moves(const std::string& changes, const std::string& header = "") const {
    const recording::Recording recording = recorded(trace_text(changes, header));
    const observe::Matched matched = observe::match(model(), recording);
    std::string text;
    for (const observe::Move& move : observe::moves_of(model(), recording, matched)) {
      text += text_of(model(), move) + "\n";
    }
    return text;
  }

  /// Every step as `12 caused ...`.
  std::string steps(const std::string& changes, const std::string& header = "") const {
    static constexpr const char* kKinds[] = {"caused", "canceled", "left", "arrived", "contradiction", "settled"};
    const recording::Recording recording = recorded(trace_text(changes, header));
    const observe::Matched matched = observe::match(model(), recording);
    observe::Observer observer(model(), matched.recorded, recording.resolution);
    std::string text;
    observe::play(recording, matched, observer, [&](tables::Time time, const observe::Step& step) {
      text += ms(time) + " " + kKinds[static_cast<std::size_t>(step.kind)] + " " + text_of(model(), step.move) + "\n";
    });
    return text;
  }

  const model::PlantModel& model() const { return plant_.compiled().plant; }

 private:
  DescribedPlant plant_;
};

}  // namespace symplant::test
