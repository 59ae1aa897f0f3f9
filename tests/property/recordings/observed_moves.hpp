// Compares the moves that an observer sees with those that a plant made.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/plant_model.hpp"
#include "observe/observer.hpp"
#include "property/recordings/true_moves.hpp"

namespace symplant::property {

/// What became of moves.
struct MoveCounts {
  long happened = 0;    ///< moves of the plant that ended, without reversals
  long shown = 0;       ///< of these between two states that have events
  long shown_seen = 0;  ///< of these with the right cause and exact times
  long seen = 0;        ///< of these with the right cause and exact times
  long observed = 0;    ///< by the observer
  long turned = 0;      ///< of these: marked as such, so not judged
  long uncaused = 0;    ///< without a known cause
  long judged = 0;
  long wrong = 0;  ///< with times that their transition does not have

  MoveCounts& operator+=(const MoveCounts& other);
};

struct WrongMove {
  observe::Move move;
  std::string text;
};

/// Judges moves by the true times, which two moves of a unit have in common only by chance, with a tolerance for each
/// time and each stop. Adds a line for each wrong one to `wrong`.
MoveCounts judge_moves(const model::PlantModel& real, const std::vector<observe::Move>& observed,
                       const std::vector<TrueMove>& happened, tables::Time tolerance, std::vector<WrongMove>& wrong);

/// For messages: device, states, transition and all times in ms.
std::string move_text(const model::PlantModel& plant, const observe::Move& move);

}  // namespace symplant::property
