// Lets an observer follow a recording.
#include "observe/play.hpp"

#include "observe/replay.hpp"

namespace symplant::observe {
namespace {

using recording::Recording;

/// Lets an observer follow, and passes its steps on.
struct Player {
  Observer& observer;
  const std::function<void(Time, const Step&)>& step;

  void set(std::uint32_t symbol, double value) { observer.set(symbol, value); }
  void close(Time time) {
    for (const Step& one : observer.close(time)) step(time, one);
  }
  void gap(Time, Time) { observer.forget(); }
};

}  // namespace

void play(const Recording& recording, const Matched& matched, Observer& observer,
          const std::function<void(Time, const Step&)>& step) {
  Player player{observer, step};
  replay(recording, matched, player);
}

std::vector<Move> moves_of(const model::PlantModel& plant, const Recording& recording, const Matched& matched) {
  Observer observer(plant, matched.recorded, recording.resolution);
  std::vector<Move> moves;
  play(recording, matched, observer, [&](Time, const Step& step) {
    const bool ends = step.kind == Step::Kind::arrived ||
                      (step.kind == Step::Kind::left && step.move.to != kNone && !observer.view(step.move.unit).moving);
    if (ends) moves.push_back(step.move);
  });
  return moves;
}

}  // namespace symplant::observe
